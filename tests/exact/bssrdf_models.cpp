// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
// BSSRDF models against the closed forms of their papers, against figures of other programs, and against their own integrals.
#include <cmath>

#include <gtest/gtest.h>

#include "bssrdf/diffusion.hpp"
#include "common/bssrdf_model.hpp"
#include "tyndall/tyndall_exact.h"

namespace {

using namespace tyn_test;

constexpr double pi = 3.14159265358979323846;

double albedo_of(uint32_t model, double albedo, double ior, double g = 0) {
  return half_space_model(model, albedo, ior, g).albedo()[0];
}

// Jensen et al. 2001, eq. 4 and the total below it, written out once more.
double dipole(double r, double albedo, double ior) {
  const double f_dr = -1.440 / (ior * ior) + 0.710 / ior + 0.668 + 0.0636 * ior, a = (1 + f_dr) / (1 - f_dr);
  const double tr = std::sqrt(3 * (1 - albedo)), z_r = 1, z_v = 1 + 4 * a / 3;
  const double d_r = std::sqrt(r * r + z_r * z_r), d_v = std::sqrt(r * r + z_v * z_v);
  return albedo / (4 * pi) *
         (z_r * (1 + tr * d_r) * std::exp(-tr * d_r) / std::pow(d_r, 3) +
          z_v * (1 + tr * d_v) * std::exp(-tr * d_v) / std::pow(d_v, 3));
}

TEST(StandardDipole, IsTheFormulaOfThePaper) {
  for (double albedo : {0.2, 0.8, 0.99, 1.0})
    for (double ior : {1.0, 1.33, 1.5})
      for (double scale : {1.0, 1e-4, 3e5}) {
        const BssrdfModel model = half_space_model(TYN_BSSRDF_STANDARD_DIPOLE, albedo, ior, 0, scale);
        for (double x : {1e-3, 0.1, 1.0, 3.0, 10.0}) {
          const double expected = dipole(x, albedo, ior) * scale * scale;
          EXPECT_NEAR(double(model.profile({float(x / scale)})[0]), expected, 1e-5 * expected) << albedo << " " << x;
        }
      }
}

TEST(StandardDipole, HasTheTotalOfThePaper) {
  for (double albedo : {0.2, 0.8, 0.99})
    for (double ior : {1.0, 1.33, 1.5}) {
      const double f_dr = -1.440 / (ior * ior) + 0.710 / ior + 0.668 + 0.0636 * ior, a = (1 + f_dr) / (1 - f_dr);
      const double s = std::sqrt(3 * (1 - albedo));
      EXPECT_NEAR(albedo_of(TYN_BSSRDF_STANDARD_DIPOLE, albedo, ior),
                  albedo / 2 * (1 + std::exp(-4.0 / 3 * a * s)) * std::exp(-s), 1e-9);
    }
}

TEST(StandardDipole, SeesAnisotropyBySimilarityOnly) {
  EXPECT_NEAR(albedo_of(TYN_BSSRDF_STANDARD_DIPOLE, 0.9, 1.4, 0.8), albedo_of(TYN_BSSRDF_STANDARD_DIPOLE, 0.9, 1.4),
              1e-9);
}

// Totals that another implementation of d'Eon's formulas gives, to the digits it prints.
TEST(BetterDipole, HasTheTotalsOfAnotherProgram) {
  const double rows[5][3] = {{0.5, 0.0460, 0.0249},
                             {0.8, 0.1988, 0.1133},
                             {0.9, 0.3438, 0.2134},
                             {0.95, 0.4858, 0.3318},
                             {0.99, 0.7379, 0.6045}};
  for (auto &row : rows) {
    EXPECT_NEAR(albedo_of(TYN_BSSRDF_BETTER_DIPOLE, row[0], 1), row[1], 1.5e-4);
    EXPECT_NEAR(albedo_of(TYN_BSSRDF_BETTER_DIPOLE, row[0], 1.4), row[2], 1.5e-4);
  }
}

// The same for photon beam diffusion with single scattering, as a renderer tabulates it with fits for the boundary.
TEST(PhotonBeamDiffusion, HasTheTotalsOfAnotherProgram) {
  const double rows[4][5] = {{0.5, 0.1280, 0.0662, 0.0590, 0.0506},
                             {0.8, 0.3260, 0.1858, 0.1666, 0.1436},
                             {0.95, 0.6085, 0.4149, 0.3819, 0.3391},
                             {0.99, 0.8413, 0.6728, 0.6413, 0.5975}};
  const double iors[] = {1.0, 1.33, 1.4, 1.5};
  for (auto &row : rows)
    for (int i = 0; i < 4; ++i)
      EXPECT_NEAR(albedo_of(TYN_BSSRDF_PHOTON_BEAM_DIFFUSION, row[0], iors[i]), row[i + 1], 0.005 * row[i + 1])
          << iors[i];
}

// What the Gaussians are a sum for: a better dipole at every depth of the beam, here by the trapezoid rule over equal shares of the
// beam.
TEST(QuantizedDiffusion, IsABetterDipoleAtEveryDepth) {
  for (double albedo : {0.5, 0.9, 0.99})
    for (double ior : {1.0, 1.4}) {
      const BssrdfModel model = half_space_model(TYN_BSSRDF_QUANTIZED_DIFFUSION, albedo, ior);
      const tyn::ExitanceBoundary boundary = tyn::exitance_boundary(ior);
      const double d = (2 - albedo) / 3, k = std::sqrt((1 - albedo) / d);
      for (double r : {0.1, 0.5, 2.0, 8.0}) {
        constexpr int SHARES = 20000;
        double sum = 0;
        for (int i = 0; i < SHARES; ++i) {
          const double z_r = -std::log((i + 0.5) / SHARES), z_v = z_r + 4 * boundary.a * d;
          const double d_r = std::hypot(r, z_r), d_v = std::hypot(r, z_v);
          const double e_r = std::exp(-k * d_r) / d_r, e_v = std::exp(-k * d_v) / d_v;
          sum += boundary.c_phi * (e_r - e_v) / d +
                 boundary.c_e * (z_r * (1 + k * d_r) * e_r / (d_r * d_r) + z_v * (1 + k * d_v) * e_v / (d_v * d_v));
        }
        const double expected = albedo * albedo * sum / (4 * pi * SHARES);
        EXPECT_NEAR(double(model.profile({float(r)})[0]), expected, 0.02 * expected)
            << albedo << " " << ior << " " << r;
      }
    }
}

// Seeliger's law, integrated over all directions that light leaves in: W/2 int mu / (1 + mu) dmu.
TEST(SingleScattering, OfAMatchedHalfSpaceIsSeeligersLaw) {
  for (double albedo : {0.1, 0.5, 1.0})
    EXPECT_NEAR(albedo_of(TYN_BSSRDF_SINGLE_SCATTERING, albedo, 1), albedo / 2 * (1 - std::log(2.0)), 1e-4 * albedo);
}

// The same of an anisotropic, finite layer: 2 pi W int p(-mu) mu / (1 + mu) (1 - exp(-tau (1 + 1 / mu))) dmu.
TEST(SingleScattering, OfAMatchedLayerIsItsIntegralOverDirections) {
  for (double g : {-0.3, 0.8})
    for (double thickness : {1e-5, 1e-2, 0.5, 3.0}) {
      double expected = 0;
      constexpr int STEPS = 200000;
      for (int i = 0; i < STEPS; ++i) {
        const double mu = (i + 0.5) / STEPS;
        const double phase = (1 - g * g) / (4 * pi * std::pow(1 + g * g + 2 * g * mu, 1.5));
        expected += 2 * pi * 0.7 * phase * mu / (1 + mu) * -std::expm1(-thickness * (1 + 1 / mu)) / STEPS;
      }
      TynBssrdfOptions options = tyn_bssrdf_options();
      options.model = TYN_BSSRDF_SINGLE_SCATTERING;
      ExactSlab slab({{0.3, 0.7, g, 1, thickness}});
      EXPECT_NEAR(BssrdfModel(slab.view(), options).albedo()[0], expected, 2e-3 * expected) << g << " " << thickness;
    }
}

// Chandrasekhar's half-space by its closed form.
TEST(NormalizedDiffusion, HasTheAlbedoOfTheMedium) {
  for (double albedo : {0.3, 0.8, 0.99}) {
    double expected = 0;
    ASSERT_EQ(tyn_half_space_albedo(albedo, 1, &expected), TYN_OK);
    EXPECT_NEAR(albedo_of(TYN_BSSRDF_NORMALIZED_DIFFUSION, albedo, 1), expected, 1e-5);
  }
}

TEST(NormalizedDiffusion, IsTheFormulaOfThePaper) {
  const double l = 0.25, sigma_t = 1 / l;
  for (uint32_t fit : {TYN_NORMALIZED_SEARCHLIGHT, TYN_NORMALIZED_DIFFUSE, TYN_NORMALIZED_DMFP}) {
    const BssrdfModel model = half_space_model(TYN_BSSRDF_NORMALIZED_DIFFUSION, 0.9, 1, 0, sigma_t, fit);
    const double a = model.albedo()[0];
    const double shapes[] = {1.85 - a + 7 * std::pow(std::abs(a - 0.8), 3), 1.9 - a + 3.5 * (a - 0.8) * (a - 0.8),
                             3.5 + 100 * std::pow(a - 0.33, 4)};
    const double unit = fit == TYN_NORMALIZED_DMFP ? l / std::sqrt(3 * (1 - 0.9)) : l, s = shapes[fit];
    for (double r : {0.01, 0.2, 1.0, 3.0}) {
      const double expected = a * s / (8 * pi * unit * r) * (std::exp(-s * r / unit) + std::exp(-s * r / (3 * unit)));
      EXPECT_NEAR(double(model.profile({float(r)})[0]), expected, 1e-5 * expected);
    }
  }
}

TEST(Gaussians, AreTheirSum) {
  const BssrdfModel model = gaussian_model();
  EXPECT_NEAR(model.albedo()[0], 0.6, 1e-12);
  for (double r : {0.001, 0.1, 0.5, 2.0, 5.0}) {
    double expected = 0;
    const double terms[3][2] = {{0.2, 0.01}, {0.3, 0.2}, {0.1, 4}};
    for (auto &t : terms)
      expected += t[0] * std::exp(-r * r / (2 * t[1])) / (2 * pi * t[1]);
    EXPECT_NEAR(double(model.profile({float(r)})[0]), expected, 2e-5 * expected);
  }
}

BssrdfModel slab_model(double albedo, double thickness, bool transmitted, double ior = 1.3) {
  TynBssrdfOptions options = tyn_bssrdf_options();
  options.model = TYN_BSSRDF_MULTIPOLE;
  options.transmitted = transmitted;
  ExactSlab slab({{1 - albedo, albedo, 0, ior, thickness}});
  return BssrdfModel(slab.view(), options);
}

TEST(Multipole, OfAThickSlabIsTheDipole) {
  const BssrdfModel thick = slab_model(0.9, 60, false), dipole = half_space_model(TYN_BSSRDF_STANDARD_DIPOLE, 0.9, 1.3);
  EXPECT_NEAR(thick.albedo()[0], dipole.albedo()[0], 1e-5);
  for (float r : {0.01f, 0.3f, 1.0f, 4.0f}) {
    const double expected = double(dipole.profile({r})[0]);
    EXPECT_NEAR(double(thick.profile({r})[0]), expected, 1e-3 * expected);
  }
  EXPECT_LT(slab_model(0.9, 60, true).albedo()[0], 1e-9);
}

// Diffusion loses nothing: what does not come back goes through, in the ratio of the distances to the extrapolated boundaries.
TEST(Multipole, OfAWhiteSlabLosesNothing) {
  for (double thickness : {2.0, 5.0, 20.0}) {
    const double z_b = 2.0 / 3 * ((1 + 0.529555) / (1 - 0.529555)); // F_dr(1.4)
    const double through = (1 + z_b) / (thickness + 2 * z_b);
    EXPECT_NEAR(slab_model(1, thickness, true, 1.4).albedo()[0], through, 2e-3 * through) << thickness;
    EXPECT_NEAR(slab_model(1, thickness, false, 1.4).albedo()[0], 1 - through, 2e-3) << thickness;
  }
}

// Boundaries that differ: the source is one mean free path below the upper one, and light leaves by the nearer, in the sense of
// the extrapolated boundaries. The ratio is that of linear diffusion.
TEST(Multipole, OfAWhiteSlabBetweenDifferentMedia) {
  TynBssrdfOptions options = tyn_bssrdf_options();
  options.model = TYN_BSSRDF_MULTIPOLE;
  auto z_b = [](double eta) {
    const double f_dr = -1.440 / (eta * eta) + 0.710 / eta + 0.668 + 0.0636 * eta;
    return 2.0 / 3 * (1 + f_dr) / (1 - f_dr);
  };
  ExactSlab slab({{0, 1, 0, 1.5, 4}}, 1, 1.3);
  for (uint32_t transmitted : {0u, 1u}) {
    options.transmitted = transmitted;
    const double through = (1 + z_b(1.5)) / (4 + z_b(1.5) + z_b(1.5 / 1.3));
    const double expected = transmitted ? through : 1 - through;
    EXPECT_NEAR(BssrdfModel(slab.view(), options).albedo()[0], expected, 2e-3 * expected);
  }
}

// Where the sum over images gives way to that over modes there is no step.
TEST(Multipole, IsOneFunction) {
  const double z_b = 2.0 / 3 * ((1 + 0.529555) / (1 - 0.529555)), border = 3 + 2 * z_b;
  for (bool transmitted : {false, true})
    for (double albedo : {0.7, 1.0}) {
      const BssrdfModel model = slab_model(albedo, 3, transmitted, 1.4);
      const std::vector<float> r = model.profile({float(0.93 * border), float(border), float(1.07 * border)});
      const double middle = std::sqrt(double(r[0]) * double(r[2]));
      EXPECT_NEAR(double(r[1]), middle, 0.01 * middle) << transmitted << " " << albedo;
    }
}

class EveryModel : public testing::TestWithParam<NamedModel> {};

TEST_P(EveryModel, IntegratesToItsAlbedo) {
  for (double albedo : {0.3, 0.9, 0.999})
    for (double ior : {1.0, 1.4}) {
      const BssrdfModel model = make_model(GetParam(), albedo, ior);
      EXPECT_NEAR(plane_integral(model, false), model.albedo()[0], 1e-4 * model.albedo()[0]) << albedo << " " << ior;
    }
}

TEST_P(EveryModel, HasADensityThatIntegratesToOne) {
  for (double albedo : {0.3, 0.999})
    EXPECT_NEAR(plane_integral(make_model(GetParam(), albedo, 1.4), true), 1, 1e-4);
}

TEST_P(EveryModel, IsFiniteAtItsLimits) {
  for (double albedo : {1e-6, 0.5, 1 - 1e-6})
    for (double ior : {1.0, 4.0})
      for (float value : make_model(GetParam(), albedo, ior).profile({1e-30f, 1e-6f, 1.0f, 1e4f, 1e12f, 1e37f})) {
        EXPECT_TRUE(std::isfinite(value)) << albedo << " " << ior;
        EXPECT_GE(value, 0);
      }
}

TEST_P(EveryModel, GivesNoLightWithoutScattering) {
  if (GetParam().model == TYN_BSSRDF_GAUSSIANS)
    return; // whose medium is not asked
  const BssrdfModel model = make_model(GetParam(), 0, 1.4);
  EXPECT_EQ(model.albedo()[0], 0);
  EXPECT_EQ(model.profile({1.0f})[0], 0);
  EXPECT_EQ(model.pdf({1.0f})[0], 0);
  const BssrdfSamples samples = model.sample(1, 0, 20);
  for (size_t i = 0; i < 20; ++i) {
    EXPECT_EQ(samples.pdf[i], 0);
    EXPECT_EQ(samples.weights[i], 0);
  }
}

// Scaling lengths by a power of two changes exponents only.
TEST_P(EveryModel, HasNoScaleOfItsOwn) {
  if (GetParam().model == TYN_BSSRDF_GAUSSIANS)
    return;
  const float scale = 0x1p20f;
  const BssrdfModel small = half_space_model(GetParam().model, 0.9, 1.4, 0, 0x1p-3, GetParam().fit);
  const BssrdfModel large = half_space_model(GetParam().model, 0.9, 1.4, 0, 0x1p-23, GetParam().fit);
  for (float r : {0.1f, 1.0f, 7.0f, 100.0f})
    EXPECT_EQ(small.profile({r})[0], large.profile({r * scale})[0] * scale * scale);
}

INSTANTIATE_TEST_SUITE_P(Of, EveryModel, testing::ValuesIn(named_models()), [](const auto &one) {
  std::string name = one.param.name;
  for (char &c : name)
    c = std::isalnum(static_cast<unsigned char>(c)) ? c : '_';
  return name;
});

} // namespace
