// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
#include "common/phases.hpp"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "common/statistics.hpp"

namespace tyn_test {
namespace {

const double pi = 3.14159265358979324;

TynPhase of_kind(uint32_t kind) {
  TynPhase phase = tyn_phase();
  phase.kind = kind;
  return phase;
}

tyn::OwnedPhase table(const std::vector<double> &cosines, const std::vector<double> &values) {
  TynPhase phase = of_kind(TYN_PHASE_TABULATED);
  phase.cosines = cosines.data();
  phase.values = values.data();
  phase.count = uint32_t(cosines.size());
  return tyn::OwnedPhase(phase);
}

double pdf(const TynPhase &phase, double cosine) {
  double value = -1;
  EXPECT_EQ(tyn_phase_pdf(&phase, &cosine, 1, &value), TYN_OK);
  return value;
}

} // namespace

TynPhase henyey_greenstein_phase(double g) {
  TynPhase phase = of_kind(TYN_PHASE_HENYEY_GREENSTEIN);
  phase.g = g;
  return phase;
}

TynPhase two_lobe_phase(double g, double g2, double weight) {
  TynPhase phase = of_kind(TYN_PHASE_TWO_LOBE);
  phase.g = g;
  phase.g2 = g2;
  phase.weight = weight;
  return phase;
}

TynPhase draine_phase(double g, double alpha) {
  TynPhase phase = of_kind(TYN_PHASE_DRAINE);
  phase.g = g;
  phase.alpha = alpha;
  return phase;
}

tyn::OwnedPhase mie_phase(double size_parameter, double n, double k, size_t count) {
  const double index[2] = {n, k};
  std::vector<double> cosines(count), values(count);
  EXPECT_EQ(tyn_mie_cosines(size_parameter, count, cosines.data()), TYN_OK);
  EXPECT_EQ(tyn_mie(size_parameter, index, nullptr, cosines.data(), count, values.data()), TYN_OK);
  return table(cosines, values);
}

std::vector<PhaseCase> phase_cases() {
  const auto owned = [](const TynPhase &phase) { return [phase] { return tyn::OwnedPhase(phase); }; };
  return {
      {"Isotropic", owned(of_kind(TYN_PHASE_ISOTROPIC))},
      {"Rayleigh", owned(of_kind(TYN_PHASE_RAYLEIGH))},
      {"HenyeyGreensteinForward", owned(henyey_greenstein_phase(0.95))},
      {"HenyeyGreensteinBackward", owned(henyey_greenstein_phase(-0.5))},
      {"TwoLobes", owned(two_lobe_phase(0.9, -0.5, 0.8))},
      {"TwoLobesOnlySecond", owned(two_lobe_phase(0.9, 0.3, 0))},
      {"DraineCornetteShanks", owned(draine_phase(0.7, 1))},
      {"DraineBackward", owned(draine_phase(-0.4, 20))},
      {"DraineSquare", owned(draine_phase(0, 1e6))},
      {"TableCoarse",
       [] {
         return table({-1, -0.2, 0.1, 0.5, 1}, {1, 0, 0, 2, 5});
       }},
      {"TableOfTwo",
       [] {
         return table({-1, 1}, {3, 0});
       }},
      {"TableOfMie100", [] { return mie_phase(100, 1.33, 1e-5, 2000); }},
      {"TableOfMie3000", [] { return mie_phase(3000, 1.5, 0.01, 6000); }}, // a peak 1e-3 wide
  };
}

std::vector<double> phase_cells(const TynPhase &phase) {
  std::vector<double> cells = {-1, 1};
  if (phase.kind == TYN_PHASE_TABULATED)
    cells.assign(phase.cosines, phase.cosines + phase.count);
  for (int i = 1; i < 1000; i++) {
    cells.push_back(std::cos(pi * i / 1000));
    const double sine = std::sin(0.5 * pi * std::exp(-0.015 * i)); // of half the angle
    cells.push_back(1 - 2 * sine * sine);
    cells.push_back(2 * sine * sine - 1);
  }
  std::sort(cells.begin(), cells.end());
  cells.erase(std::unique(cells.begin(), cells.end()), cells.end());
  return cells;
}

double gauss(double a, double b, const std::function<double(double)> &f) {
  const double nodes[] = {0.18343464249564980494, 0.52553240991632898582, 0.79666647741362673959,
                          0.96028985649753623168};
  const double weights[] = {0.36268378337836198297, 0.31370664587788728734, 0.22238103445337447054,
                            0.10122853629037625915};
  double sum = 0;
  for (int i = 0; i < 4; i++)
    sum += weights[i] *
           (f(0.5 * (a + b) - 0.5 * (b - a) * nodes[i]) + f(std::min(1.0, 0.5 * (a + b) + 0.5 * (b - a) * nodes[i])));
  return 0.5 * (b - a) * sum;
}

double phase_integral(const TynPhase &phase, const std::function<double(double)> &f) {
  const auto density = tyn::phase_density(phase);
  const std::vector<double> cells = phase_cells(phase);
  double sum = 0;
  for (size_t i = 0; i + 1 < cells.size(); i++)
    sum += gauss(cells[i], cells[i + 1], [&](double c) { return f(c) * 2 * pi * density(c); });
  const double middle = 0.5 * (cells[0] + cells[1]); // the call says the same
  EXPECT_DOUBLE_EQ(pdf(phase, middle), 2 * pi * density(middle));
  return sum;
}

PhaseBins::PhaseBins(const TynPhase &phase, size_t count) : edges{-1} {
  const auto density = tyn::phase_density(phase);
  const std::vector<double> cells = phase_cells(phase);
  double share = 0;
  for (size_t i = 0; i + 1 < cells.size(); i++) {
    share += gauss(cells[i], cells[i + 1], [&](double c) { return 2 * pi * density(c); });
    if (share < 1 / double(count) && i + 2 < cells.size())
      continue;
    edges.push_back(cells[i + 1]);
    shares.push_back(share);
    share = 0;
  }
}

size_t PhaseBins::find(double cosine) const {
  const auto above = std::upper_bound(edges.begin() + 1, edges.end() - 1, cosine);
  return size_t(above - edges.begin()) - 1;
}

double PhaseBins::test(const std::vector<double> &cosines) const {
  std::vector<double> observed(shares.size()), expected;
  for (double cosine : cosines)
    observed[find(cosine)] += 1;
  for (double share : shares)
    expected.push_back(share * double(cosines.size()));
  return chi_square_test(observed, expected);
}

} // namespace tyn_test
