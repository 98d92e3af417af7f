// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
// Lorenz-Mie scattering against published tables, sums in 40 digits, and limits.
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "common/phases.hpp"
#include "tyndall/tyndall.h"

namespace {

const double pi = 3.14159265358979324;

TynMie efficiencies(double x, double n, double k) {
  const double index[2] = {n, k};
  TynMie mie{};
  EXPECT_EQ(tyn_mie(x, index, &mie, nullptr, 0, nullptr), TYN_OK);
  return mie;
}

std::vector<double> phase_function(double x, double n, double k, const std::vector<double> &cosines) {
  const double index[2] = {n, k};
  std::vector<double> values(cosines.size());
  EXPECT_EQ(tyn_mie(x, index, nullptr, cosines.data(), cosines.size(), values.data()), TYN_OK);
  return values;
}

// Bohren & Huffman 1983, appendix A: radius 0.525 um, wavelength 0.6328 um, m = 1.55.
TEST(Mie, IsBohrenAndHuffmansExample) {
  const TynMie mie = efficiencies(2 * pi * 0.525 / 0.6328, 1.55, 0);
  EXPECT_NEAR(mie.q_ext, 3.10543, 5e-6);
  EXPECT_NEAR(mie.q_sca, 3.10543, 5e-6);
  EXPECT_NEAR(mie.q_back, 2.92534, 5e-6);
  EXPECT_EQ(mie.q_abs, 0.0);
}

// Summed in 40 digits from Bessel functions of mpmath 1.4, an independent program: Q_ext, Q_sca, Q_back, mean cosine, and p at
// cos = -1, -1/2, 0, 1/2, 0.9, 1.
struct Row {
  double x, n, k, q_ext, q_sca, q_back, mean_cosine, p[6];
};
const Row rows[] = {
    {5.213,
     1.55,
     0,
     3.104995915080185,
     3.104995915080185,
     2.924209127229018,
     0.6331044159946938,
     {0.07494411425351527, 0.01257243409228848, 0.02438254732147581, 0.06293128468462352, 0.1908521338271115,
      1.956226890170058}},
    {0.1,
     0.75,
     0,
     7.721112356972368e-6,
     7.721112356972368e-6,
     1.153787623948569e-5,
     0.001477681547839043,
     {0.1189148630014716, 0.07447074656957006, 0.05968296281100411, 0.07473686578638625, 0.1083909783900422,
      0.1198184641432798}},
    {0.009,
     1.5,
     0.1,
     0.001793348623553233,
     1.576117352784945e-9,
     2.364085744447006e-9,
     1.603587746288921e-5,
     {0.1193616488826143, 0.07460228488569871, 0.05968310364445634, 0.07460547425120307, 0.1080302081204333,
      0.1193707658346653}},
    {0.0099,
     1.01,
     0,
     1.134599025123005e-12,
     1.134599025123005e-12,
     1.701831637610014e-12,
     1.57395319880419e-5,
     {0.1193615151425168, 0.07460240972437997, 0.05968310364363335, 0.07460534940949449, 0.1080302410754934,
      0.1193708995900128}},
    {0.02,
     1.5,
     0.1,
     0.003985968395323973,
     3.843691028049229e-8,
     5.764449310483408e-8,
     7.918749466163823e-5,
     {0.1193436979287753, 0.07459600463003918, 0.05968310329357259, 0.07461175423208403, 0.1080451361178301,
      0.1193887186461499}},
    {1e-3,
     0.2,
     3,
     0.000288684383141736,
     5.380302591990264e-12,
     8.070456375472151e-12,
     -1.852662538794071e-7,
     {0.1193662441101434, 0.07460390494290827, 0.05968310365946429, 0.07460385420574492, 0.108026381331841,
      0.1193661705276876}},
    {10,
     1.5,
     0,
     2.881998952075897,
     2.881998952075897,
     1.695063583409524,
     0.7429128985686781,
     {0.04680392891197386, 0.004857777577179649, 0.01013380390262236, 0.03772530103930993, 0.01897630567033754,
      5.752729205550056}},
    {10,
     1.5,
     1,
     2.417294528490904,
     1.346957826094464,
     0.1729262018798157,
     0.8346946423125499,
     {0.01021637770912269, 0.01009234035529485, 0.01213529894521624, 0.01819423131491477, 0.1482027710001579,
      8.767915378074179}},
    {100,
     1.33,
     1e-5,
     2.10132070588027,
     2.096593506393609,
     2.146326524057994,
     0.8689592720023575,
     {0.08146511823855299, 0.001362387902537917, 0.001176952466899121, 0.01235155150410211, 0.126645647963578,
      419.2216827453408}},
    {30,
     10,
     10,
     2.12231558234642,
     1.874037039102005,
     0.8397234039670179,
     0.5583764220663384,
     {0.03565728098825183, 0.03439915435298282, 0.03297158647381996, 0.03839067805746869, 0.05386194858807703,
      43.03438417570395}},
    {2,
     2.5,
     0,
     3.601555226292408,
     3.601555226292408,
     7.472742501641627,
     0.1586817025937538,
     {0.1651125462281889, 0.04551399488552627, 0.05956382860041845, 0.05458310156834372, 0.205612133793329,
      0.3053548710789824}},
    {200,
     0.75,
     0.001,
     2.028544983996156,
     1.803726228278481,
     0.003502920639494067,
     0.848473987527055,
     {0.0001545431691056025, 0.001645403969096239, 0.00458600524318485, 0.02138737365192291, 0.01368445313798524,
      1820.773999443586}},
};

TEST(Mie, IsTheSumIn40Digits) {
  for (const Row &row : rows) {
    SCOPED_TRACE("x = " + std::to_string(row.x) + ", m = " + std::to_string(row.n) + " + i " + std::to_string(row.k));
    const TynMie mie = efficiencies(row.x, row.n, row.k);
    EXPECT_NEAR(mie.q_ext, row.q_ext, 1e-9 * row.q_ext);
    EXPECT_NEAR(mie.q_sca, row.q_sca, 1e-9 * row.q_sca);
    EXPECT_NEAR(mie.q_abs, row.q_ext - row.q_sca, 1e-9 * row.q_ext);
    EXPECT_NEAR(mie.q_back, row.q_back, 1e-9 * row.q_back);
    EXPECT_NEAR(mie.mean_cosine, row.mean_cosine, 1e-9 * std::abs(row.mean_cosine));
    const std::vector<double> p = phase_function(row.x, row.n, row.k, {-1, -0.5, 0, 0.5, 0.9, 1});
    for (size_t i = 0; i < 6; i++)
      EXPECT_NEAR(p[i], row.p[i], 1e-9 * row.p[i]) << i;
  }
}

// The error of Rayleigh's formula is of order x^2; the sizes straddle where the library changes its formula.
TEST(Mie, OfSmallSpheresIsRayleighs) {
  const double indices[][2] = {{1.33, 0}, {1.5, 0.3}, {0.3, 2}};
  for (const double(&index)[2] : indices)
    for (double radius : {1e-45, 1e-20, 1e-9, 1e-6, 1e-4, 1e-3}) {
      const double x = 2 * pi * radius;
      double cross_section = 0;
      ASSERT_EQ(tyn_rayleigh_cross_section(radius, 1, index, &cross_section), TYN_OK);
      const TynMie mie = efficiencies(x, index[0], index[1]);
      const double limit = 20 * x * x + 1e-12;
      EXPECT_NEAR(mie.q_sca * pi * radius * radius / cross_section, 1, limit) << radius;
      EXPECT_NEAR(mie.mean_cosine, 0, limit) << radius;
      if (index[1] == 0) {
        EXPECT_NEAR(mie.q_ext / mie.q_sca, 1, 1e-9) << radius;
      }
      const std::vector<double> p = phase_function(x, index[0], index[1], {-1, 0, 0.5});
      EXPECT_NEAR(p[0], 3 / (8 * pi), limit);
      EXPECT_NEAR(p[1], 3 / (16 * pi), limit);
      EXPECT_NEAR(p[2], 3.75 / (16 * pi), limit);
    }
}

// Bohren & Huffman 1983, eq. 5.8, in numbers: x = 0.1, m = 1.5, radius 1 / (20 pi).
TEST(Mie, RayleighsCrossSectionIsItsFormula) {
  const double index[2] = {1.5, 0}, radius = 1 / (20 * pi);
  double one = 0, half = 0;
  ASSERT_EQ(tyn_rayleigh_cross_section(radius, 1, index, &one), TYN_OK);
  EXPECT_NEAR(one, 8.0 / 3 * 1e-4 * (1.25 / 4.25) * (1.25 / 4.25) * pi * radius * radius, 1e-15 * one + 1e-22);
  ASSERT_EQ(tyn_rayleigh_cross_section(radius, 2, index, &half), TYN_OK);
  EXPECT_NEAR(one / half, 16, 1e-12);
}

// p integrates to 1, and to the mean cosine of the series.
TEST(Mie, PhaseFunctionIsNormalized) {
  const double cases[][3] = {{0.001, 1.5, 0}, {1, 1.33, 0}, {10, 1.5, 0.1}, {50, 1.33, 0}, {100, 0.75, 0}};
  for (const double(&c)[3] : cases) {
    std::vector<double> edges(4097), nodes;
    ASSERT_EQ(tyn_mie_cosines(c[0], edges.size(), edges.data()), TYN_OK);
    for (size_t i = 0; i + 1 < edges.size(); i++)
      tyn_test::gauss(edges[i], edges[i + 1], [&](double cosine) {
        nodes.push_back(cosine);
        return 0.0;
      });
    const std::vector<double> p = phase_function(c[0], c[1], c[2], nodes);
    size_t next = 0;
    double integral = 0, mean = 0;
    for (size_t i = 0; i + 1 < edges.size(); i++) {
      const size_t first = next;
      integral += 2 * pi * tyn_test::gauss(edges[i], edges[i + 1], [&](double) { return p[next++]; });
      next = first;
      mean += 2 * pi * tyn_test::gauss(edges[i], edges[i + 1], [&](double cosine) { return cosine * p[next++]; });
    }
    EXPECT_NEAR(integral, 1, 1e-9) << c[0];
    EXPECT_NEAR(mean, efficiencies(c[0], c[1], c[2]).mean_cosine, 1e-9) << c[0];
  }
}

// The largest sphere allowed, transparent and absorbing: twice the geometric cross-section (Bohren & Huffman 1983, section 4.4.3).
TEST(Mie, LargeSpheresTakeOutTwiceTheirShadow) {
  const double cases[][2] = {{1.33, 0}, {1.5, 0.01}, {1.5, 10}, {0.1, 5}, {100, 0}};
  for (const double(&c)[2] : cases) {
    const TynMie mie = efficiencies(1e5, c[0], c[1]);
    EXPECT_NEAR(mie.q_ext, 2, 5e-3) << c[0];
    EXPECT_GT(mie.q_sca, 1) << c[0];
    EXPECT_LE(mie.q_sca, mie.q_ext * (1 + 1e-9)) << c[0];
    EXPECT_GE(mie.q_abs, 0) << c[0];
    EXPECT_LT(std::abs(mie.mean_cosine), 1) << c[0];
  }
}

TEST(Mie, ASphereThatIsNotThereScattersNothing) {
  const TynMie mie = efficiencies(0.001, 1, 0);
  EXPECT_EQ(mie.q_ext, 0.0);
  EXPECT_EQ(mie.q_sca, 0.0);
  EXPECT_EQ(mie.mean_cosine, 0.0);
  EXPECT_NEAR(phase_function(0.001, 1, 0, {0.3})[0], 1 / (4 * pi), 1e-15);
}

TynMieDistribution distribution(double radius, double deviation, double n, double k) {
  TynMieDistribution result = tyn_mie_distribution();
  result.median_radius = radius;
  result.geometric_deviation = deviation;
  result.wavelength = 0.5;
  result.relative_index[0] = n;
  result.relative_index[1] = k;
  return result;
}

TEST(MieLognormal, OfDeviation1IsOneSphere) {
  const double radius = 0.7, x = 2 * pi * radius / 0.5, area = pi * radius * radius;
  const TynMie mie = efficiencies(x, 1.5, 0.02);
  const std::vector<double> cosines = {-1, 0, 0.5, 1};
  for (double deviation : {1.0, 1 + 1e-9}) {
    const TynMieDistribution given = distribution(radius, deviation, 1.5, 0.02);
    TynMieCrossSections sections{};
    std::vector<double> p(cosines.size());
    ASSERT_EQ(tyn_mie_lognormal(&given, &sections, cosines.data(), cosines.size(), p.data()), TYN_OK);
    EXPECT_NEAR(sections.extinction, area * mie.q_ext, 1e-7 * area);
    EXPECT_NEAR(sections.scattering, area * mie.q_sca, 1e-7 * area);
    EXPECT_NEAR(sections.absorption, area * mie.q_abs, 1e-7 * area);
    EXPECT_NEAR(sections.mean_cosine, mie.mean_cosine, 1e-7);
    const std::vector<double> single = phase_function(x, 1.5, 0.02, cosines);
    for (size_t i = 0; i < p.size(); i++)
      EXPECT_NEAR(p[i], single[i], 1e-6 * single[i]) << i;
  }
}

// The mean of r^6 over a log-normal distribution is median^6 exp(18 log(deviation)^2): Rayleigh's cross-section times that.
TEST(MieLognormal, OfSmallSpheresIsASixthMoment) {
  const TynMieDistribution given = distribution(1e-8, 1.6, 1.5, 0);
  double rayleigh = 0;
  ASSERT_EQ(tyn_rayleigh_cross_section(1e-8, 0.5, given.relative_index, &rayleigh), TYN_OK);
  TynMieCrossSections sections{};
  ASSERT_EQ(tyn_mie_lognormal(&given, &sections, nullptr, 0, nullptr), TYN_OK);
  const double s = std::log(1.6), factor = std::exp(18 * s * s);
  EXPECT_NEAR(sections.scattering / (rayleigh * factor), 1, 1e-9);
  EXPECT_NEAR(sections.extinction / sections.scattering, 1, 1e-9);
}

// Against Simpson's rule over the single spheres; p is normalized.
TEST(MieLognormal, IsTheMeanOverSpheres) {
  const double median = 0.3, s = std::log(1.8);
  double scattering = 0, extinction = 0, cosine = 0;
  const int n = 10000;
  for (int i = 0; i <= n; i++) {
    const double z = -7 + 17.0 * i / n, r = median * std::exp(s * z);
    const double simpson = (i == 0 || i == n ? 1 : i % 2 ? 4 : 2) * 17.0 / n / 3;
    const double weight = simpson * std::exp(-0.5 * z * z) / std::sqrt(2 * pi) * pi * r * r;
    const TynMie mie = efficiencies(2 * pi * r / 0.5, 1.4, 0.001);
    extinction += weight * mie.q_ext;
    scattering += weight * mie.q_sca;
    cosine += weight * mie.q_sca * mie.mean_cosine;
  }
  const TynMieDistribution given = distribution(median, 1.8, 1.4, 0.001);
  std::vector<double> cosines(400), p(cosines.size());
  ASSERT_EQ(tyn_mie_cosines(100, cosines.size(), cosines.data()), TYN_OK);
  TynMieCrossSections sections{};
  ASSERT_EQ(tyn_mie_lognormal(&given, &sections, cosines.data(), cosines.size(), p.data()), TYN_OK);
  EXPECT_NEAR(sections.extinction / extinction, 1, 1e-6);
  EXPECT_NEAR(sections.scattering / scattering, 1, 1e-6);
  EXPECT_NEAR(sections.mean_cosine, cosine / scattering, 1e-6);
  EXPECT_NEAR(sections.absorption, sections.extinction - sections.scattering, 1e-9 * extinction);
  double integral = 0;
  for (size_t i = 0; i + 1 < p.size(); i++)
    integral += pi * (p[i] + p[i + 1]) * (cosines[i + 1] - cosines[i]);
  EXPECT_NEAR(integral, 1, 1e-3); // the error of the trapezoidal rule
}

TEST(MieCosines, IncreaseStrictlyAndFollowThePeak) {
  for (double x : {1e-6, 1.0, 100.0, 1e5})
    for (size_t count : {size_t(2), size_t(3), size_t(1000), size_t(65536)}) {
      std::vector<double> cosines(count);
      ASSERT_EQ(tyn_mie_cosines(x, count, cosines.data()), TYN_OK);
      EXPECT_EQ(cosines.front(), -1.0);
      EXPECT_EQ(cosines.back(), 1.0);
      for (size_t i = 1; i < count; i++)
        ASSERT_GT(cosines[i], cosines[i - 1]) << x << " " << i;
      if (count >= 1000) {
        const auto within = [&](double angle) { return 2 * std::pow(std::sin(angle / 2), 2); };
        size_t inside = 0;
        for (double cosine : cosines)
          inside += 1 - cosine < within(std::min(pi / 2, 1 / x));
        EXPECT_GT(inside, count / 50) << x;
      }
    }
}

} // namespace
