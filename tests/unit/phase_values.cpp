// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
// Values, densities and moments of every kind of phase function, against quadrature of its own values and closed forms.
#include <cmath>

#include <gtest/gtest.h>

#include "common/phases.hpp"
#include "core/opencl_shim.hpp"

namespace {

using namespace tyn_test;

double value(const TynPhase &phase, double cosine) {
  double result = -1;
  EXPECT_EQ(tyn_phase_value(&phase, &cosine, 1, &result), TYN_OK);
  return result;
}

std::vector<double> moments(const TynPhase &phase, size_t count) {
  std::vector<double> result(count);
  EXPECT_EQ(tyn_phase_moments(&phase, count, result.data()), TYN_OK);
  return result;
}

class PhaseValues : public testing::TestWithParam<PhaseCase> {
protected:
  const tyn::OwnedPhase owned = GetParam().make();
  const TynPhase &phase = owned.get();
};

TEST_P(PhaseValues, IntegrateToOne) {
  EXPECT_NEAR(phase_integral(phase, [](double) { return 1.0; }), 1, 1e-6);
}

TEST_P(PhaseValues, HaveTheMomentsOfTheirQuadrature) {
  const std::vector<double> chi = moments(phase, 31);
  EXPECT_NEAR(chi[0], 1, 1e-10);
  double mean = 0;
  EXPECT_EQ(tyn_phase_mean_cosine(&phase, &mean), TYN_OK);
  EXPECT_NEAR(mean, chi[1], 1e-15);
  for (unsigned l = 0; l < chi.size(); l++)
    EXPECT_NEAR(chi[l], phase_integral(phase, [l](double c) { return std::legendre(l, c); }), 1e-9) << l;
}

// The kernels' single-precision values, from 1 - cos.
TEST_P(PhaseValues, AreThoseOfTheKernels) {
  tyn::PhaseTables tables;
  const TynPhaseRecord record = tables.add(phase);
  const std::vector<double> cells = phase_cells(phase);
  for (size_t i = 0; i < cells.size(); i += 3) {
    const float away = static_cast<float>(1 - cells[i]);
    const double cosine = 1 - double(away), exact = value(phase, cosine);
    // near cos = -1 a float holds the cosine to 1e-7 only
    const double slack = std::abs(value(phase, std::min(1.0, cosine + 1.2e-7 * away)) - exact);
    EXPECT_NEAR(tyn_kernel::tyn_phase_value_away(record, tables.data.data(), away), exact,
                4e-6 * exact + 2 * slack + 1e-7)
        << cosine;
  }
}

INSTANTIATE_TEST_SUITE_P(OfAllKinds, PhaseValues, testing::ValuesIn(phase_cases()),
                         [](const auto &parameter) { return parameter.param.name; });

TEST(PhaseValue, IntegratesToOneAtTheSharpestPeaks) {
  for (double g : {-0.999, -0.99, 0.99, 0.999, 0.99999})
    for (const TynPhase &phase : {henyey_greenstein_phase(g), draine_phase(g, 2), two_lobe_phase(g, -g, 0.3)})
      EXPECT_NEAR(phase_integral(phase, [](double) { return 1.0; }), 1, 1e-6) << g;
}

TEST(PhaseValue, IsTheClosedForm) {
  const double pi = 3.14159265358979324;
  TynPhase phase = tyn_phase();
  EXPECT_DOUBLE_EQ(value(phase, 0.3), 1 / (4 * pi));
  phase.kind = TYN_PHASE_RAYLEIGH;
  EXPECT_DOUBLE_EQ(value(phase, 0.5), 3 / (16 * pi) * 1.25);
  EXPECT_NEAR(value(henyey_greenstein_phase(0.5), 0.25), 0.75 / (4 * pi), 1e-15); // 1 + g^2 - 2 g cos = 1
  EXPECT_NEAR(value(henyey_greenstein_phase(-0.5), -0.25), 0.75 / (4 * pi), 1e-15);
  EXPECT_NEAR(value(two_lobe_phase(0.5, 0, 0.25), 0.25), (0.25 * 0.75 + 0.75) / (4 * pi), 1e-15);
}

TEST(PhaseValue, DraineHasItsLimits) {
  TynPhase rayleigh = tyn_phase();
  rayleigh.kind = TYN_PHASE_RAYLEIGH;
  for (double cosine = -1; cosine <= 1; cosine += 0.125) {
    EXPECT_DOUBLE_EQ(value(draine_phase(0.6, 0), cosine), value(henyey_greenstein_phase(0.6), cosine));
    EXPECT_DOUBLE_EQ(value(draine_phase(0, 1), cosine), value(rayleigh, cosine));
  }
  const std::vector<double> a = moments(draine_phase(0, 1), 8), b = moments(rayleigh, 8);
  for (size_t l = 0; l < a.size(); l++)
    EXPECT_NEAR(a[l], b[l], 1e-15) << l;
  EXPECT_NEAR(b[2], 0.1, 1e-15);
}

// Draine 2003, eq. 5: <cos> = g (1 + alpha (3 + 2 g^2) / 5) / (1 + alpha (1 + 2 g^2) / 3).
TEST(PhaseMoments, OfDraineAreThePublishedMean) {
  for (double g : {-0.7, 0.2, 0.9})
    for (double alpha : {0.0, 0.5, 1.0, 30.0})
      EXPECT_NEAR(moments(draine_phase(g, alpha), 2)[1],
                  g * (1 + alpha * (3 + 2 * g * g) / 5) / (1 + alpha * (1 + 2 * g * g) / 3), 1e-14);
}

// Far beyond what the entries resolve, where closed forms of narrow intervals cancel. The function of a table is the sum of
// hats; Henyey-Greenstein's own moments are met as far as its table of 65536 entries follows it.
TEST(PhaseMoments, OfANarrowPeakStayPrecise) {
  const double g = 0.999;
  const TynPhase exact = henyey_greenstein_phase(g);
  TynPhase phase = tyn_phase();
  phase.kind = TYN_PHASE_TABULATED;
  phase.count = 65536;
  std::vector<double> cosines(phase.count), values(phase.count);
  ASSERT_EQ(tyn_mie_cosines(1000, phase.count, cosines.data()), TYN_OK);
  ASSERT_EQ(tyn_phase_value(&exact, cosines.data(), phase.count, values.data()), TYN_OK);
  phase.cosines = cosines.data();
  phase.values = values.data();
  const std::vector<double> chi = moments(phase, 1001);
  for (size_t l : {0, 1, 10, 100, 1000})
    EXPECT_NEAR(chi[l], std::pow(g, double(l)), 2e-6) << l;
}

TEST(PhaseValue, OfATableDoesNotDependOnItsScale) {
  const double cosines[] = {-1, 0, 1};
  for (double scale : {1e-300, 1.0, 1e308}) {
    const double values[] = {0, scale, 0};
    TynPhase phase = tyn_phase();
    phase.kind = TYN_PHASE_TABULATED;
    phase.cosines = cosines;
    phase.values = values;
    phase.count = 3;
    EXPECT_NEAR(value(phase, 0.5), 0.5 / (2 * 3.14159265358979324), 1e-15) << scale;
  }
}

TEST(PhaseName, IsTheOneInTheHeader) {
  const char *names[] = {"isotropic", "rayleigh", "henyey-greenstein", "two-lobe", "draine", "tabulated"};
  for (uint32_t kind = 0; kind < TYN_PHASE_KIND_COUNT; kind++)
    EXPECT_STREQ(tyn_phase_name(kind), names[kind]);
  EXPECT_EQ(tyn_phase_name(TYN_PHASE_KIND_COUNT), nullptr);
}

} // namespace
