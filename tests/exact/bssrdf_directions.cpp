// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
// S over directions: what it adds up to, what it is a product of, and which way light may go.
#include <algorithm>
#include <cmath>
#include <cstring>

#include <gtest/gtest.h>

#include "common/bssrdf_model.hpp"
#include "common/bssrdf_paths.hpp"
#include "slab/gauss.hpp"

namespace {

using namespace tyn_test;

constexpr double pi = 3.14159265358979323846;

// Of one channel, with an index of its own, outside or inside.
BssrdfModel model_between(const NamedModel &named, double albedo, double ior, double above) {
  TynBssrdfOptions options = tyn_bssrdf_options();
  options.model = named.model;
  options.exact_events = few_events(ior);
  options.fit = named.fit;
  const double weights[] = {0.2, 0.3, 0.1}, variances[] = {0.01, 0.2, 4};
  options.gaussian_count = 3;
  options.gaussian_weights = weights;
  options.gaussian_variances = variances;
  ExactSlab slab({{1 - albedo, albedo, 0, ior, INFINITY}}, above);
  return BssrdfModel(slab.view(), options);
}

// int S cos over the directions that light leaves in, by Gauss-Legendre over t, mu = critical + (1 - critical) t^2, which the
// root that F has at the critical angle does not disturb, and three azimuths.
double exitance(const BssrdfModel &model, TynBssrdfPath path, double ior) {
  const tyn::Quadrature rule = tyn::gauss_legendre(48);
  const double critical = ior < 1 ? std::sqrt(1 - ior * ior) : 0, side = double(path.exit_normal[2]);
  std::vector<TynBssrdfPath> paths;
  std::vector<double> weights;
  for (size_t i = 0; i < rule.points.size(); ++i)
    for (int azimuth = 0; azimuth < 3; ++azimuth) {
      const double t = rule.points[i], mu = critical + (1 - critical) * t * t, sine = std::sqrt(1 - mu * mu);
      const double angle = 0.3 + 2 * pi / 3 * azimuth;
      path.exit_direction[0] = float(sine * std::cos(angle));
      path.exit_direction[1] = float(sine * std::sin(angle));
      path.exit_direction[2] = float(mu * side);
      paths.push_back(path);
      weights.push_back(2 * pi / 3 * mu * rule.weights[i] * 2 * (1 - critical) * t);
    }
  const std::vector<float> values = model.evaluate(paths);
  double sum = 0;
  for (size_t i = 0; i < paths.size(); ++i)
    sum += weights[i] * double(values[i]);
  return sum;
}

class DirectionsOf : public testing::TestWithParam<NamedModel> {};

// R per power that gets in, F_t(w_i) of what arrives. The directional models' R is of light from above; the rule has not the
// steps of the exact model's table.
TEST_P(DirectionsOf, AddUpToTheProfile) {
  const bool table = GetParam().model == TYN_BSSRDF_EXACT;
  const bool directional = table || GetParam().model == TYN_BSSRDF_DIRECTIONAL_DIPOLE;
  const double tolerance = table ? 2e-3 : 3e-5;
  for (double ior : {1.0, 1.33, 1.5, 3.0}) {
    const BssrdfModel model = model_between(GetParam(), 0.9, ior, 1);
    for (double r : {1e-3, 0.3, 1.0, 4.0})
      for (double angle : {0.0, 0.7, 1.4}) {
        if (directional && angle != 0)
          continue;
        const double expected = transmittance(std::cos(angle), ior) * double(model.profile({float(r)})[0]);
        EXPECT_NEAR(exitance(model, plane_path(r, angle), ior), expected, tolerance * expected) << ior << " " << r;
      }
  }
}

// A product of what gets in and what gets out, at any angle, between any media that the model takes.
TEST_P(DirectionsOf, AreFresnels) {
  if (GetParam().model == TYN_BSSRDF_EXACT)
    return; // which has a table of angles besides
  for (double above : {1.0, 1.8}) {
    if (above > 1 && GetParam().model != TYN_BSSRDF_GAUSSIANS)
      continue; // which take no medium of a lower index than outside
    for (double ior : {1.0, 1.33, 1.5, 3.0}) {
      const BssrdfModel model = model_between(GetParam(), 0.9, ior, above);
      const double normal = double(model.evaluate({plane_path(0.5)})[0]) / std::pow(transmittance(1, ior / above), 2);
      ASSERT_GT(normal, 0);
      for (double entry : {0.0, 0.5, 1.2, 1.55})
        for (double exit : {-1.57, -1.0, 0.0, 0.4, 1.3, 1.56}) {
          if (GetParam().model == TYN_BSSRDF_DIRECTIONAL_DIPOLE && entry != 0)
            continue;
          const TynBssrdfPath path = plane_path(0.5, entry, exit);
          const double expected = normal * transmittance(-double(path.entry_direction[2]), ior / above) *
                                  transmittance(double(path.exit_direction[2]), ior / above);
          EXPECT_NEAR(double(model.evaluate({path})[0]), expected, 1e-5 * expected)
              << ior << " " << entry << " " << exit;
        }
    }
  }
}

// Entry and exit exchanged: the same bits, at random places on random surfaces.
TEST_P(DirectionsOf, AreReciprocal) {
  if (GetParam().model == TYN_BSSRDF_DIRECTIONAL_DIPOLE)
    return; // which is not
  const BssrdfModel model = model_between(GetParam(), 0.9, 1.4, 1);
  std::vector<TynBssrdfPath> paths = random_paths(5000, 11, 1e-4, 15), back;
  for (const TynBssrdfPath &path : paths)
    back.push_back(reversed(path));
  const std::vector<float> values = model.evaluate(paths);
  EXPECT_EQ(std::memcmp(values.data(), model.evaluate(back).data(), values.size() * sizeof(float)), 0);
  EXPECT_GT(*std::min_element(values.begin(), values.end()), 0);
}

TEST_P(DirectionsOf, AreNoneInside) {
  const BssrdfModel model = model_between(GetParam(), 0.9, 1.4, 1);
  for (double entry : {0.3, 1.5})
    for (double exit : {0.2, 1.5}) {
      EXPECT_GT(model.evaluate({plane_path(1, entry, exit)})[0], 0);
      EXPECT_EQ(model.evaluate({plane_path(1, pi - entry, exit)})[0], 0);
      EXPECT_EQ(model.evaluate({plane_path(1, entry, pi - exit)})[0], 0);
      EXPECT_EQ(model.evaluate({plane_path(1, pi - entry, pi - exit)})[0], 0);
    }
  TynBssrdfPath along = plane_path(1);
  along.entry_direction[0] = 1, along.entry_direction[2] = 0;
  EXPECT_EQ(model.evaluate({along})[0], 0);
  along = plane_path(1);
  along.exit_direction[1] = 1, along.exit_direction[2] = 0;
  EXPECT_EQ(model.evaluate({along})[0], 0);
}

// Points that are the same, or nearly, or far from each other; light that grazes; white, nearly black and black media.
TEST_P(DirectionsOf, AreFiniteAtTheirLimits) {
  std::vector<TynBssrdfPath> paths;
  for (double r : {0.0, 1e-30, 1e-12, 1e-6, 1.0, 1e3, 1e8, 1e20, 3e38})
    for (double entry : {0.0, 1.0, pi / 2 - 1e-7, pi / 2 - 1e-3})
      for (double exit : {0.0, 1.0, pi / 2 - 1e-7, -1.5})
        for (double turn : {0.0, 0.7, 1.57, 3.1}) {
          TynBssrdfPath path = plane_path(r, entry, exit + turn);
          path.exit_normal[0] = float(std::sin(turn)), path.exit_normal[2] = float(std::cos(turn));
          paths.push_back(path);
          std::swap(path.exit_position[0], path.exit_position[2]); // above the other
          paths.push_back(path);
        }
  for (double albedo : {0.0, 1e-6, 0.9, 1 - 1e-6, 1.0}) {
    if (albedo == 1 && GetParam().fit == TYN_NORMALIZED_DMFP)
      continue;
    for (double ior : {1.0, 1.4, 4.0})
      for (float value : model_between(GetParam(), albedo, ior, 1).evaluate(paths)) {
        EXPECT_TRUE(std::isfinite(value)) << albedo << " " << ior;
        EXPECT_GE(value, 0);
      }
  }
}

INSTANTIATE_TEST_SUITE_P(Of, DirectionsOf, testing::ValuesIn(named_models()), [](const auto &one) {
  std::string name = one.param.name;
  for (char &c : name)
    c = std::isalnum(static_cast<unsigned char>(c)) ? c : '_';
  return name;
});

// Of a medium of a lower index than outside, which only Gaussians take: beyond the critical angle nothing gets in or out.
TEST(DirectionsOfGaussians, AreNoneBeyondTheCriticalAngle) {
  const NamedModel gaussians{"gaussians", TYN_BSSRDF_GAUSSIANS, 0};
  for (double above : {1.05, 1.5, 3.9}) {
    const BssrdfModel model = model_between(gaussians, 0.9, 1, above);
    const double critical = std::asin(1 / above),
                 expected = transmittance(1, 1 / above) * double(model.profile({0.3f})[0]);
    EXPECT_NEAR(exitance(model, plane_path(0.3), 1 / above), expected, 3e-5 * expected);
    EXPECT_GT(model.evaluate({plane_path(0.3, 0.99 * critical)})[0], 0);
    EXPECT_EQ(model.evaluate({plane_path(0.3, 1.01 * critical)})[0], 0);
    EXPECT_EQ(model.evaluate({plane_path(0.3, 0, -1.01 * critical)})[0], 0);
  }
}

// What leaves below a slab goes through that boundary, and its distance is counted across the slab.
class DirectionsThroughSlabs : public testing::TestWithParam<std::vector<ExactLayer>> {};

TEST_P(DirectionsThroughSlabs, AddUpToTheProfileBelow) {
  TynBssrdfOptions options = tyn_bssrdf_options();
  options.model = TYN_BSSRDF_MULTIPOLE;
  options.transmitted = 1;
  ExactSlab slab(GetParam(), 1, 1.3);
  const BssrdfModel model(slab.view(), options);
  for (double r : {0.01, 1.0, 5.0})
    for (double angle : {0.0, 1.2}) {
      TynBssrdfPath path = plane_path(r, angle);
      path.exit_position[2] = -3;
      path.exit_normal[2] = -1;
      const double expected = transmittance(std::cos(angle), 1.5) * double(model.profile({float(r)})[0]);
      EXPECT_NEAR(exitance(model, path, 1.5 / 1.3), expected, 3e-5 * expected) << r << " " << angle;
    }
}

const std::vector<ExactLayer> one_layer = {{0.1, 0.9, 0, 1.5, 3}};
const std::vector<ExactLayer> two_layers = {{0.1, 0.9, 0, 1.5, 1.6}, {0.02, 1.2, 0, 1.5, 1.4}};
INSTANTIATE_TEST_SUITE_P(Of, DirectionsThroughSlabs, testing::Values(one_layer, two_layers));

// Where the outside is denser there is no light beyond the critical angle, and the rest adds up.
TEST(DirectionsOfExact, AreThoseOfDenserSurroundings) {
  const NamedModel exact{"exact", TYN_BSSRDF_EXACT, TYN_NORMALIZED_SEARCHLIGHT};
  for (double above : {1.05, 1.33, 1.51}) {
    const BssrdfModel model = model_between(exact, 0.9, 1, above);
    const double critical = std::asin(1 / above);
    for (double r : {0.01, 0.3, 4.0}) {
      const double expected = transmittance(1, 1 / above) * double(model.profile({float(r)})[0]);
      EXPECT_NEAR(exitance(model, plane_path(r), 1 / above), expected, 3e-3 * expected) << above << " " << r;
    }
    EXPECT_EQ(model.evaluate({plane_path(0.3, 1.01 * critical)})[0], 0);
  }
}

} // namespace
