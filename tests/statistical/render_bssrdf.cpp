// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
// A BSSRDF model in place of walks. Under light that is 1 from everywhere a flat surface shows what it reflects,
// F + (1 - F) albedo, F at perpendicular view; and a sphere what a model's profile integrates to over it. The albedos are those
// of the models (tests/exact has them from other sources).
//
// Means over the film are within 4 standard errors, which a right program exceeds once in 16 000 times; films are 24 x 24
// pixels with the stated samples.
#include <algorithm>
#include <cmath>
#include <string>

#include <gtest/gtest.h>

#include "common/bssrdf_model.hpp"
#include "common/render_scene.hpp"
#include "common/statistics.hpp"
#include "common/walk_scene.hpp"

namespace {

using namespace tyn_test;

constexpr float ALBEDO[] = {0.9f, 0.6f, 0.95f}, SIGMA_T[] = {1, 3, 0.5f};

TynMedium coloured(float ior, const float (&albedo)[3] = ALBEDO) {
  TynMedium medium = tyn_medium();
  for (int c = 0; c < 3; ++c) {
    medium.sigma_s[c] = albedo[c] * SIGMA_T[c];
    medium.sigma_a[c] = SIGMA_T[c] - medium.sigma_s[c];
  }
  medium.ior = ior;
  return medium;
}

TynMaterial clear_surface(float ior) {
  TynMaterial material = tyn_material();
  material.ior = ior;
  material.roughness = 0;
  material.transmission = 1;
  return material;
}

// A block of 4000 mean free paths, with the width as u.
MeshData block() {
  MeshData mesh = unwelded(box(4000, 4000, 4000));
  for (uint32_t v = 0; v < mesh.vertex_count(); ++v)
    mesh.uvs.insert(mesh.uvs.end(), {mesh.positions[3 * v] / 4000 + 0.5f, 0.5f});
  return mesh;
}

struct Object {
  MeshData mesh;
  TynMedium medium;
  TynMaterial material;
  const TynImage *image = nullptr; // of multiscatter_color
};

// From far away, at the middle of the block's upper face or what is below it.
TynCamera camera(double half_height, double angle) {
  const double y = angle == 0 ? 0 : 2000;
  return look_at_flat({9000 * std::sin(angle), y + 9000 * std::cos(angle), 0}, {0, y, 0}, {0, 0, -1}, half_height);
}

// From above or at an angle from the normal, `half_height` in view, in light of radiance 1 that the camera does not see.
class Picture {
public:
  Picture(const Object &object, uint32_t model, double half_height, uint32_t samples, double angle = 0)
      : scene(context) {
    uint32_t medium = TYN_NONE, material = TYN_NONE, image = TYN_NONE;
    TynMaterial surface = object.material;
    if (object.image) {
      EXPECT_EQ(tyn_scene_add_image(scene, object.image, &image), TYN_OK) << scene.message();
      surface.multiscatter_color_texture.image = image;
      surface.multiscatter_color_texture.filter = TYN_FILTER_NEAREST;
    }
    EXPECT_EQ(tyn_scene_add_medium(scene, &object.medium, &medium), TYN_OK) << scene.message();
    EXPECT_EQ(tyn_scene_add_material(scene, &surface, &material), TYN_OK) << scene.message();
    scene.add(object.mesh, medium, material);
    TynEnvironment environment = constant_environment(1);
    environment.hidden_from_camera = 1;
    EXPECT_EQ(tyn_scene_set_environment(scene, &environment), TYN_OK);
    scene.commit();
    TynRenderOptions options = film_options(24, 24, camera(half_height, angle));
    options.bssrdf = model;
    options.seed = 4;
    render.reset(new Render(scene, options));
    render->run(samples);
  }

  // Mean over columns [from, to).
  Estimate mean(uint32_t channel, size_t from = 0, size_t to = 24) const {
    const std::vector<float> beauty = render->layer(TYN_LAYER_BEAUTY), variance = render->layer(TYN_LAYER_VARIANCE);
    double sum = 0, spread = 0, count = 0;
    for (size_t i = 0; i < 24 * 24; ++i)
      if (i % 24 >= from && i % 24 < to) {
        sum += double(beauty[4 * i + channel]);
        spread += double(variance[3 * i + channel]);
        count++;
      }
    return {sum / count, std::sqrt(spread) / count};
  }

  TynLedger ledger() const { return render->stats().ledger; }

private:
  Context context;
  Scene scene;
  std::unique_ptr<Render> render;
};

void expect_mean(const Estimate &found, double expected, double systematic = 0) {
  EXPECT_NEAR(found.mean, expected, four_sigma * found.standard_error + systematic);
  EXPECT_LT(found.standard_error, 0.02 * expected); // or the test says little
}

double normal_reflectance(double ior) { return std::pow((ior - 1) / (ior + 1), 2); }

double shown(uint32_t model, double albedo, double ior) {
  const double f = normal_reflectance(ior);
  return f + (1 - f) * half_space_model(model, albedo, ior).albedo()[0];
}

class RenderBssrdf : public testing::TestWithParam<uint32_t> {};

// 128 samples.
TEST_P(RenderBssrdf, ShowsAFlatSurfacesAlbedo) {
  for (const float ior : {1.0f, 1.4f}) {
    const Picture picture({block(), coloured(ior), clear_surface(ior)}, GetParam(), 10, 128);
    for (uint32_t c = 0; c < 3; ++c) {
      SCOPED_TRACE(std::to_string(ior) + " " + std::to_string(c));
      expect_mean(picture.mean(c), shown(GetParam(), double(ALBEDO[c]), double(ior)), 1e-6);
    }
    const TynLedger ledger = picture.ledger();
    for (int c = 0; c < 3; ++c) {
      EXPECT_NEAR(accounted(ledger, c) / ledger.entered[c], 1, 1e-5);
      EXPECT_NEAR(ledger.balance[c] / ledger.entered[c], 0, 0.02);
    }
    EXPECT_EQ(ledger.walks, ledger.escaped_walks + ledger.absorbed_walks);
    EXPECT_EQ(ledger.lost[0] + ledger.leaked[0], 0);
  }
}

// From the side the exact model shows what adding and doubling has for that angle; so do walks. Between two of a table's angles
// and in its statistics there is 0.5 %. 128 samples.
TEST(RenderExactBssrdf, ShowsAFlatSurfaceFromAllSidesAsWalksDo) {
  for (const float ior : {1.0f, 1.4f})
    for (const double angle : {0.0, 0.7, 1.2})
      for (const uint32_t model : {uint32_t(TYN_BSSRDF_EXACT), TYN_NONE}) {
        const Picture picture({block(), coloured(ior), clear_surface(ior)}, model, 10, 128, angle);
        for (uint32_t c = 0; c < 3; ++c) {
          SCOPED_TRACE(std::to_string(ior) + " " + std::to_string(angle) + " " + std::to_string(c));
          const double albedo = double(ALBEDO[c]);
          ExactSlab slab({{1 - albedo, albedo, 0, double(ior), INFINITY}});
          const double expected = slab.angle(angle).solve().reflectance;
          expect_mean(picture.mean(c), expected, model == TYN_NONE ? 1e-3 * expected : 5e-3 * expected);
        }
      }
}

std::vector<uint32_t> models() {
  std::vector<uint32_t> models;
  for (uint32_t model = 0; model < TYN_BSSRDF_MODEL_COUNT; ++model)
    if (model != TYN_BSSRDF_GAUSSIANS)
      models.push_back(model);
  return models;
}

std::string model_name(const testing::TestParamInfo<uint32_t> &info) {
  std::string name = tyn_bssrdf_model_name(info.param);
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
}

INSTANTIATE_TEST_SUITE_P(WithEveryModel, RenderBssrdf, testing::ValuesIn(models()), model_name);

// A sphere of radius `radius` about a point of itself: rings between chords d and d + dd have the area 2 pi d dd. So light at
// every point comes from the part of the profile below the diameter. 256 samples; 1e-3 for the tessellation.
TEST(RenderBssrdfOfASphere, IntegratesTheProfileOverIt) {
  const TynMedium medium = grey_medium(0.2f, 0.8f);
  const BssrdfModel model = half_space_model(TYN_BSSRDF_NORMALIZED_DIFFUSION, 0.8);
  const std::vector<float> far = model.profile({20, 40}); // falls off like exp(-r / 3 l) / r
  const double length = 20 / (3 * std::log(20 * double(far[0]) / (40 * double(far[1]))));
  const float radius = 1.5f;
  const double x = 2 * double(radius) / length;
  const double part = 1 - std::exp(-x) / 4 - 3 * std::exp(-x / 3) / 4;
  EXPECT_LT(part, 0.95);
  const Picture picture({without_normals(icosphere(5, radius)), medium, clear_surface(1)},
                        TYN_BSSRDF_NORMALIZED_DIFFUSION, 0.9, 256);
  for (uint32_t c = 0; c < 3; ++c)
    expect_mean(picture.mean(c), model.albedo()[0] * part, 1e-3);
}

// ---- Albedos of the entry point's own --------------------------------------------------------------------------------------

TynMaterial with_color(float ior, const float (&color)[3]) {
  TynMaterial material = clear_surface(ior);
  std::copy(color, color + 3, material.multiscatter_color);
  return material;
}

// The medium's own albedos, once as they are and once by way of the colours that they give.
TEST(RenderBssrdfOfColours, AreTheMediumsOwnWhereTheyAreTheSame) {
  const float color[] = {0.5f, 0.2f, 0.7f};
  const float albedo[] = {tyn_albedo_from_color(color[0], 0), tyn_albedo_from_color(color[1], 0),
                          tyn_albedo_from_color(color[2], 0)};
  const uint32_t model = TYN_BSSRDF_BETTER_DIPOLE;
  const Picture own({block(), coloured(1.4f, albedo), clear_surface(1.4f)}, model, 10, 128);
  const Picture by_color({block(), coloured(1.4f, albedo), with_color(1.4f, color)}, model, 10, 128);
  for (uint32_t c = 0; c < 3; ++c) {
    const Estimate a = own.mean(c), b = by_color.mean(c);
    expect_mean(a, shown(model, double(albedo[c]), 1.4), 1e-6);
    EXPECT_NEAR(a.mean, b.mean, 1e-4); // the same random numbers
  }
}

// Others than the medium's: blends of the profiles that were prepared.
TEST(RenderBssrdfOfColours, AreThoseOfMediaWithTheirAlbedos) {
  for (const uint32_t model : {TYN_BSSRDF_NORMALIZED_DIFFUSION, TYN_BSSRDF_BETTER_DIPOLE}) {
    const float color[] = {0.83f, 0.31f, 0.04f};
    const Picture picture({block(), coloured(1.4f), with_color(1.4f, color)}, model, 10, 256);
    for (uint32_t c = 0; c < 3; ++c)
      expect_mean(picture.mean(c), shown(model, double(tyn_albedo_from_color(color[c], 0)), 1.4), 2e-4);
  }
}

TEST(RenderBssrdfOfColours, ComeFromTextures) {
  const float pixels[] = {0.83f, 0.31f, 0.04f, 1, 0.2f, 0.6f, 0.4f, 1};
  TynImage image = tyn_image();
  image.width = 2;
  image.height = 1;
  image.format = TYN_IMAGE_RGBA32F;
  image.pixels = pixels;
  const uint32_t model = TYN_BSSRDF_BETTER_DIPOLE;
  const float white[] = {1, 1, 1};
  const Picture both({block(), coloured(1.4f), with_color(1.4f, white), &image}, model, 10, 256);
  for (size_t side = 0; side < 2; ++side) { // but for the columns in the middle, which see both
    const float color[] = {pixels[4 * side], pixels[4 * side + 1], pixels[4 * side + 2]};
    const Picture one({block(), coloured(1.4f), with_color(1.4f, color)}, model, 10, 256);
    for (uint32_t c = 0; c < 3; ++c) {
      const Estimate a = both.mean(c, 13 * side, 13 * side + 11), b = one.mean(c);
      EXPECT_NEAR(a.mean, b.mean, four_sigma * std::hypot(a.standard_error, b.standard_error));
      EXPECT_LT(a.standard_error, 0.03 * a.mean);
    }
  }
}

} // namespace
