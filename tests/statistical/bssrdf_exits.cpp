// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
// Exit points on meshes. What a model's profile integrates to over a surface is known in closed form for Gaussians on flat
// faces, so the estimate's mean must be that: with each point counted by every axis and hit that it can come from.
//
// Means are within 4 standard errors, which a right program exceeds once in 16 000 times, of a given number of samples.
#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "common/bssrdf_exits.hpp"
#include "common/statistics.hpp"

namespace {

using namespace tyn_test;

constexpr size_t COUNT = 400000;

// Those of gaussian_model().
constexpr double WEIGHTS[] = {0.2, 0.3, 0.1}, VARIANCES[] = {0.01, 0.2, 4};
constexpr double ALBEDO = 0.6;

// The chance that one coordinate of a Gaussian is in [low, high].
double gaussian_part(double variance, double low, double high) {
  const double scale = 1 / std::sqrt(2 * variance);
  return 0.5 * (std::erf(high * scale) - std::erf(low * scale));
}

// int R(|x - p|) dA over an axis-aligned rectangle, `height` away from p, sides in coordinates about p.
double over_rectangle(double height, double a0, double a1, double b0, double b1) {
  double sum = 0;
  for (int i = 0; i < 3; ++i)
    sum += WEIGHTS[i] * std::exp(-height * height / (2 * VARIANCES[i])) * gaussian_part(VARIANCES[i], a0, a1) *
           gaussian_part(VARIANCES[i], b0, b1);
  return sum;
}

// The same over the surface of the box [lower, upper].
double over_box(const double (&p)[3], const double (&lower)[3], const double (&upper)[3]) {
  double sum = 0;
  for (int axis = 0; axis < 3; ++axis) {
    const int a = (axis + 1) % 3, b = (axis + 2) % 3;
    for (const double face : {lower[axis], upper[axis]})
      sum += over_rectangle(face - p[axis], lower[a] - p[a], upper[a] - p[a], lower[b] - p[b], upper[b] - p[b]);
  }
  return sum;
}

double gaussian_profile(double squared) {
  double sum = 0;
  for (int i = 0; i < 3; ++i)
    sum += WEIGHTS[i] / (2 * 3.14159265358979 * VARIANCES[i]) * std::exp(-squared / (2 * VARIANCES[i]));
  return sum;
}

Mean mean_of(const BssrdfExits &found, size_t channel = 0) {
  Mean mean;
  const size_t count = found.exits.size();
  for (size_t i = 0; i < count; ++i)
    mean.add(double(found.weights[channel * count + i]));
  return mean;
}

void expect_mean(const Mean &mean, double expected, double lost = 0) {
  EXPECT_NEAR(mean.mean(), expected, four_sigma * mean.standard_error() + 1e-6 * expected + lost); // rounding
  EXPECT_LT(mean.standard_error(), 0.01 * expected); // or the test says little
}

// ---- A plane --------------------------------------------------------------------------------------------------------------

// The chance of a radius below r, in closed form.
double cumulative_gaussians(double r) {
  double sum = 0;
  for (int i = 0; i < 3; ++i)
    sum -= WEIGHTS[i] / ALBEDO * std::expm1(-r * r / (2 * VARIANCES[i]));
  return sum;
}

double cumulative_exponentials(double x) { return 1 - std::exp(-x) / 4 - 3 * std::exp(-x / 3) / 4; }

// Chi-square over 60 bins; a right program fails once in 1e4 times. Of an entry's probes the one across the plane finds it.
template <class F>
void expect_radii(const BssrdfExits &found, F &&cumulative) {
  std::vector<double> observed(60), expected;
  for (int i = 0; i < 60; ++i)
    expected.push_back(COUNT *
                       (cumulative(1e-3 * std::pow(10, 0.1 * (i + 1))) - cumulative(1e-3 * std::pow(10, 0.1 * i))));
  for (const TynBssrdfExit &exit : found.exits) {
    const int bin = int(std::floor((std::log10(double(exit.distance)) + 3) * 10));
    if (exit.status == TYN_BSSRDF_EXIT_FOUND && bin >= 0 && bin < 60)
      ++observed[size_t(bin)];
  }
  EXPECT_GT(chi_square_test(observed, expected), 1e-4);
}

TEST(ExitsOnAPlane, HaveTheProfilesDensity) {
  const SceneHandle scene = bare_scene(shared_context(), quad(4000));
  const TynBssrdfEntry entry = bssrdf_entry({0.3f, 0, -0.2f}, {0, 1, 0});
  expect_radii(exits_of(gaussian_model(), scene.get(), entry, COUNT, 1), cumulative_gaussians);
  // its length l by how it falls off far away: like exp(-r / 3 l) / r
  const BssrdfModel diffusion = half_space_model(TYN_BSSRDF_NORMALIZED_DIFFUSION, 0.9);
  const std::vector<float> far = diffusion.profile({20, 40});
  const double length = (40 - 20) / (3 * std::log(20 * double(far[0]) / (40 * double(far[1]))));
  expect_radii(exits_of(diffusion, scene.get(), entry, COUNT, 2),
               [&](double r) { return cumulative_exponentials(r / length); });
}

TEST(ExitsOnAPlane, WeighToTheAlbedo) {
  const SceneHandle scene = bare_scene(shared_context(), quad(4000));
  const TynBssrdfEntry entry = bssrdf_entry({0.3f, 0, -0.2f}, {0, 1, 0});
  expect_mean(mean_of(exits_of(gaussian_model(), scene.get(), entry, COUNT, 3)), ALBEDO);
  for (const NamedModel &named : named_models()) {
    const BssrdfModel model = make_model(named, 0.9, 1.4);
    SCOPED_TRACE(named.name);
    expect_mean(mean_of(exits_of(model, scene.get(), entry, COUNT / 4, 4)), model.albedo()[0]);
  }
}

// The normal need not be the surface's: then every axis sees the plane, at an angle. Far away one of them only, and not all:
// see tyn_bssrdf_sample_exits.
TEST(ExitsOnAPlane, WeighToTheAlbedoWhateverTheNormal) {
  const SceneHandle scene = bare_scene(shared_context(), quad(4000));
  const std::vector<std::vector<float>> normals = {{0.6f, 0.8f, 0}, {0.48f, 0.6f, 0.64f}, {0, -1, 0}, {1, 0, 0}};
  for (const std::vector<float> &n : normals) {
    const TynBssrdfEntry entry = bssrdf_entry({0, 0, 0}, {n[0], n[1], n[2]});
    expect_mean(mean_of(exits_of(gaussian_model(), scene.get(), entry, COUNT, 5)), ALBEDO, 1e-3 * ALBEDO);
  }
}

// A plane along no axis of coordinates, so that no point of it is exactly in the plane across the normal. Of 400 000 exits the
// farthest 1/2000, beyond the radius within which probes see everything, are there too: 200, within 4 standard deviations.
TEST(ExitsOnAPlane, AreFoundFarAway) {
  const double n[] = {0.48, 0.6, 0.64}, e[] = {0.8, 0, -0.6}, f[] = {-0.36, 0.8, -0.48}; // f = n x e
  MeshData plane = quad(4000);
  for (uint32_t v = 0; v < plane.vertex_count(); ++v) {
    float *p = &plane.positions[3 * v];
    const double x = double(p[0]), z = double(p[2]);
    for (int k = 0; k < 3; ++k)
      p[k] = float(x * e[k] + z * f[k]);
  }
  const SceneHandle scene = bare_scene(shared_context(), plane);
  const TynBssrdfEntry entry = bssrdf_entry({0, 0, 0}, {float(n[0]), float(n[1]), float(n[2])});
  const BssrdfExits found = exits_of(gaussian_model(), scene.get(), entry, COUNT, 10);
  double far = 0; // 0.1 / 0.6 exp(-r^2 / 8) = 1 / 2000
  for (const TynBssrdfExit &exit : found.exits)
    far += double(exit.distance) > std::sqrt(8 * std::log(2000.0 / 6));
  EXPECT_NEAR(far, 200, 4 * std::sqrt(200.0));
  expect_mean(mean_of(found), ALBEDO, 1e-4 * ALBEDO);
}

// Channels of very different extent share one radius.
TEST(ExitsOnAPlane, WeighToTheAlbedoOfEachChannel) {
  const double sigma_a[] = {0.01, 0.5, 1, 0.2}, sigma_s[] = {1, 20, 0, 0.4};
  TynSlabLayer layer = tyn_slab_layer();
  layer.sigma_a = sigma_a;
  layer.sigma_s = sigma_s;
  TynSlab slab = tyn_slab();
  slab.channel_count = 4;
  slab.layer_count = 1;
  slab.layers = &layer;
  TynBssrdfOptions options = tyn_bssrdf_options();
  options.model = TYN_BSSRDF_BETTER_DIPOLE;
  const BssrdfModel model(slab, options);
  const SceneHandle scene = bare_scene(shared_context(), quad(4000));
  const BssrdfExits found = exits_of(model, scene.get(), bssrdf_entry({0, 0, 0}, {0, 1, 0}), COUNT, 6);
  for (size_t c : {0u, 1u, 3u})
    expect_mean(mean_of(found, c), model.albedo()[c]);
  EXPECT_EQ(mean_of(found, 2).mean(), 0);
}

// ---- Several points on one probe -------------------------------------------------------------------------------------------

TEST(ExitsOnASheet, CountBothSides) {
  const SceneHandle scene = bare_scene(shared_context(), box(60, 0.2f, 60));
  const BssrdfExits found =
      exits_of(gaussian_model(), scene.get(), bssrdf_entry({0.5f, 0.1f, 0.25f}, {0, 1, 0}), COUNT, 7);
  const double expected = over_box({0.5, 0.1, 0.25}, {-30, -0.1, -30}, {30, 0.1, 30});
  EXPECT_GT(expected, 1.3 * ALBEDO); // the lower side counts
  expect_mean(mean_of(found), expected);
  size_t twice = 0;
  for (const TynBssrdfExit &exit : found.exits)
    twice += exit.hits == 2;
  EXPECT_GT(twice, COUNT / 3);
}

// How far beyond the plane through the origin, seen from the entry.
double beyond(const TynBssrdfEntry &entry, double x, double y, double z) {
  return -(double(entry.normal[0]) * x + double(entry.normal[1]) * y + double(entry.normal[2]) * z);
}

// int R dA over what of a mesh is `lowest` or more beyond, each triangle in 4^3 parts with a point each.
double over_mesh(const MeshData &mesh, const TynBssrdfEntry &entry, double lowest) {
  const MeshData fine = subdivided(subdivided(subdivided(mesh)));
  double sum = 0;
  for (uint32_t t = 0; t < fine.triangle_count(); ++t) {
    double p[3][3], e[2][3], centre[3], squared = 0;
    for (int v = 0; v < 3; ++v)
      for (int k = 0; k < 3; ++k)
        p[v][k] = double(fine.positions[3 * fine.indices[3 * t + uint32_t(v)] + uint32_t(k)]);
    for (int k = 0; k < 3; ++k) {
      e[0][k] = p[1][k] - p[0][k];
      e[1][k] = p[2][k] - p[0][k];
      centre[k] = (p[0][k] + p[1][k] + p[2][k]) / 3;
      squared += std::pow(centre[k] - double(entry.position[k]), 2);
    }
    const double area = 0.5 * std::hypot(e[0][1] * e[1][2] - e[0][2] * e[1][1], e[0][2] * e[1][0] - e[0][0] * e[1][2],
                                         e[0][0] * e[1][1] - e[0][1] * e[1][0]);
    if (beyond(entry, centre[0], centre[1], centre[2]) >= lowest)
      sum += area * gaussian_profile(squared);
  }
  return sum;
}

TEST(ExitsOnASphere, IntegrateTheProfileOverIt) {
  const MeshData sphere = icosphere(4);
  const SceneHandle scene = bare_scene(shared_context(), sphere);
  float at[3] = {0, 0, 0}, normal[3];
  for (uint32_t v = 0; v < 3; ++v)
    for (uint32_t k = 0; k < 3; ++k)
      at[k] += sphere.positions[3 * sphere.indices[v] + k] / 3;
  const float length = std::sqrt(at[0] * at[0] + at[1] * at[1] + at[2] * at[2]);
  for (int k = 0; k < 3; ++k)
    normal[k] = at[k] / length;
  const TynBssrdfEntry entry = bssrdf_entry(at, normal);

  const double expected = over_mesh(sphere, entry, -2), expected_behind = over_mesh(sphere, entry, 0.2);
  // a ring of a unit sphere between chords d and d + dd has the area 2 pi d dd
  double closed_form = 0;
  for (int i = 0; i < 3; ++i)
    closed_form -= WEIGHTS[i] * std::expm1(-2 / VARIANCES[i]);
  EXPECT_NEAR(expected, closed_form, 0.003 * closed_form);
  EXPECT_GT(expected_behind, 0.02 * expected);

  const BssrdfExits found = exits_of(gaussian_model(), scene.get(), entry, COUNT, 8);
  Mean behind;
  size_t several = 0;
  for (size_t i = 0; i < COUNT; ++i) {
    const TynBssrdfExit &exit = found.exits[i];
    const double depth = beyond(entry, double(exit.position[0]), double(exit.position[1]), double(exit.position[2]));
    behind.add(exit.status == TYN_BSSRDF_EXIT_FOUND && depth >= 0.2 ? double(found.weights[i]) : 0);
    several += exit.hits > 1;
  }
  expect_mean(mean_of(found), expected);
  expect_mean(behind, expected_behind, 1e-4 * expected); // the border cuts through triangles
  EXPECT_GT(several, COUNT / 2);
}

// ---- Several meshes --------------------------------------------------------------------------------------------------------

// Another cube touches the corner that light gets in at; its surface is none of this one's.
TEST(ExitsOfTouchingMeshes, StayOnTheirOwn) {
  TynScene *created = nullptr;
  ASSERT_EQ(tyn_scene_create(shared_context(), nullptr, &created), TYN_OK);
  const SceneHandle scene(created);
  const MeshData other = translated(cube(), 2, 0, 0), own = cube();
  for (const MeshData *mesh : {&other, &own}) {
    const TynMesh view = mesh->view();
    ASSERT_EQ(tyn_scene_add_mesh(created, &view, nullptr), TYN_OK);
  }
  ASSERT_EQ(tyn_scene_commit(created), TYN_OK);
  const BssrdfExits found = exits_of(gaussian_model(), created, bssrdf_entry({0.95f, 1, 0.9f}, {0, 1, 0}, 1), COUNT, 9);
  expect_mean(mean_of(found), over_box({double(0.95f), 1, double(0.9f)}, {-1, -1, -1}, {1, 1, 1}));
  for (const TynBssrdfExit &exit : found.exits)
    if (exit.status == TYN_BSSRDF_EXIT_FOUND) {
      ASSERT_LT(exit.triangle, 12u);
      ASSERT_LE(exit.position[0], 1.0f);
    }
}

} // namespace
