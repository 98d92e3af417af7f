// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
// The rough interface: the density of one bounce against what the samples do, the energy and the reciprocity of all bounces.
#include <cmath>
#include <random>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "core/opencl_shim.hpp"
#include "common/statistics.hpp"

namespace {

using namespace tyn_kernel;

const double pi = 3.14159265358979324;

// Bins over the sphere of outgoing directions: equal in cosine and azimuth.
constexpr int rows = 24, columns = 16, cells = rows * columns;

int cell_of(float3 o) {
  double phi = std::atan2(o.y, o.x) / (2 * pi);
  int row = std::min(rows - 1, int((o.z + 1) * 0.5 * rows));
  int column = std::min(columns - 1, int((phi < 0 ? phi + 1 : phi) * columns));
  return row * columns + column;
}

float3 direction_at(double cosine, double phi) {
  double sine = std::sqrt(std::max(0.0, 1 - cosine * cosine));
  return tyn_vec3(static_cast<float>(sine * std::cos(phi)), static_cast<float>(sine * std::sin(phi)),
                  static_cast<float>(cosine));
}

// Travels down at `degrees` from the normal, within the plane y = 0.
float3 arriving_at(double degrees) {
  double angle = degrees * pi / 180;
  return tyn_vec3(static_cast<float>(std::sin(angle)), 0.0f, static_cast<float>(-std::cos(angle)));
}

struct Arrival {
  double degrees;
  float eta, alpha;
};

class OneBounce : public testing::TestWithParam<Arrival> {};

// Chance of each cell by the density, and of meeting the microsurface again as the last entry. The azimuth is symmetric.
std::vector<double> expected_cells(float3 d, float eta, float alpha) {
  const int sub = 40;
  std::vector<double> expected(cells + 1);
  double total = 0;
  for (int i = 0; i < rows * sub; ++i)
    for (int j = 0; j < columns * sub / 2; ++j) {
      float3 o = direction_at(-1 + 2 * (i + 0.5) / (rows * sub), 2 * pi * (j + 0.5) / (columns * sub));
      double share = tyn_interface_bounce_value(d, o, eta, alpha) * 4 * pi / (double(rows * sub) * (columns * sub));
      int row = i / sub, column = j / sub;
      expected[size_t(row * columns + column)] += share;
      expected[size_t(row * columns + columns - 1 - column)] += share;
      total += 2 * share;
    }
  expected[cells] = 1 - total;
  return expected;
}

// N = 4e5; false-alarm rate 1e-4 for each arrival.
TEST_P(OneBounce, HasTheDensityThatItsValueSays) {
  const Arrival &a = GetParam();
  const int samples = 400000;
  float3 d = arriving_at(a.degrees);
  std::vector<double> expected = expected_cells(d, a.eta, a.alpha), observed(cells + 1);
  for (double &e : expected)
    e *= samples;
  std::mt19937 random(12);
  auto uniform = [&] { return tyn_uniform(static_cast<uint>(random())); };
  for (int i = 0; i < samples; ++i) {
    float u0 = uniform(), u1 = uniform(), u2 = uniform();
    int transmitted;
    float3 o = tyn_interface_bounce(d, a.eta, a.alpha, u0, u1, u2, &transmitted);
    float3 away = transmitted ? -o : o; // as seen from the side where it is
    bool leaves = uniform() < tyn_ggx_g1(away, a.alpha);
    observed[size_t(leaves ? cell_of(o) : cells)] += 1;
  }
  EXPECT_GT(tyn_test::chi_square_test(observed, expected), 1e-4);
}

INSTANTIATE_TEST_SUITE_P(FromBothSides, OneBounce,
                         testing::Values(Arrival{10, 1.5f, 0.3f}, Arrival{60, 1.5f, 0.3f}, Arrival{60, 1.5f, 0.8f},
                                         Arrival{80, 1.5f, 0.5f}, Arrival{10, 1 / 1.5f, 0.3f},
                                         Arrival{35, 1 / 1.5f, 0.5f}, Arrival{60, 1 / 1.5f, 0.3f},
                                         Arrival{80, 1 / 1.5f, 0.8f}),
                         [](const auto &parameter) {
                           return std::string(parameter.param.eta > 1 ? "Outside" : "Inside") +
                                  std::to_string(int(parameter.param.degrees)) + "DegreesAlpha" +
                                  std::to_string(int(std::lround(parameter.param.alpha * 10))) + "Tenths";
                         });

InterfaceSample sample_interface(float3 d, float eta, float alpha, uint path) {
  return tyn_interface_sample(d, eta, alpha, tyn_uint4(path, 0, 0, 0), tyn_uint2(13, 0));
}

// Whatever arrives leaves, once, on the side that it is said to be on: the weight is always 1.
TEST(AllBounces, LoseNoEnergy) {
  for (float eta : {1.5f, 1 / 1.5f, 1.0f})
    for (float alpha : {0.0f, 2e-3f, 0.1f, 0.5f, 1.0f})
      for (double degrees : {0.0, 45.0, 80.0, 89.99})
        for (uint path = 0; path < 2000; ++path) {
          InterfaceSample sample = sample_interface(arriving_at(degrees), eta, alpha, path);
          float3 o = sample.direction;
          ASSERT_TRUE(sample.transmitted ? o.z < 0 : o.z > 0) << eta << " " << alpha << " " << degrees;
          ASSERT_NEAR(tyn_dot(o, o), 1, 1e-5) << eta << " " << alpha << " " << degrees;
        }
}

TEST(AllBounces, AtASmoothInterfaceAreFresnels) {
  const int samples = 200000; // false-alarm rate 6e-5 for each angle
  for (double degrees : {0.0, 56.3, 80.0}) {
    double chance = tyn_fresnel(static_cast<float>(std::cos(degrees * pi / 180)), 1.5f), reflected = 0;
    for (uint path = 0; path < samples; ++path)
      reflected += !sample_interface(arriving_at(degrees), 1.5f, 0.0f, path).transmitted;
    EXPECT_NEAR(reflected / samples, chance, 4 * std::sqrt(chance * (1 - chance) / samples)) << degrees;
  }
}

TEST(AllBounces, AtMatchedMediaGoThrough) {
  for (uint path = 0; path < 20000; ++path) {
    float3 d = arriving_at(70);
    InterfaceSample sample = sample_interface(d, 1.0f, 0.5f, path);
    ASSERT_TRUE(sample.transmitted);
    ASSERT_NEAR(tyn_dot(sample.direction, d), 1, 1e-5);
  }
}

// Counts of (arriving cosine, leaving cosine) for cosine-distributed arrivals, reflected or transmitted.
constexpr int bands = 8;
struct Exchange {
  double reflected[bands][bands] = {}, transmitted[bands][bands] = {};
};

int band_of(float cosine) { return std::min(bands - 1, int(cosine * cosine * bands)); }

Exchange exchange(float eta, float alpha, uint samples, unsigned seed) {
  Exchange counts;
  std::mt19937 random(seed);
  auto uniform = [&] { return tyn_uniform(static_cast<uint>(random())); };
  for (uint path = 0; path < samples; ++path) {
    float u0 = uniform(), u1 = uniform();
    float3 d = -tyn_sample_cosine(u0, u1);
    InterfaceSample sample = sample_interface(d, eta, alpha, path);
    auto &table = sample.transmitted ? counts.transmitted : counts.reflected;
    table[band_of(-d.z)][band_of(std::fabs(sample.direction.z))] += 1;
  }
  return counts;
}

// Under cosine-distributed light as much goes from one band of angles to another as back: detailed balance. N = 1e6 for each;
// false-alarm rate 1e-4.
TEST(AllBounces, ReflectReciprocally) {
  for (float eta : {1.5f, 1 / 1.5f})
    for (float alpha : {0.3f, 0.9f}) {
      Exchange counts = exchange(eta, alpha, 1000000, 14);
      double statistic = 0;
      int pairs = 0;
      for (int i = 0; i < bands; ++i)
        for (int j = 0; j < i; ++j) {
          double there = counts.reflected[i][j], back = counts.reflected[j][i];
          if (there + back < 20)
            continue;
          statistic += (there - back) * (there - back) / (there + back);
          ++pairs;
        }
      EXPECT_GT(pairs, 10);
      EXPECT_GT(tyn_test::chi_square_tail(statistic, pairs), 1e-4) << eta << " " << alpha;
    }
}

// Through the interface, with the squares of the indices: n1^2 cos1 T12 = n2^2 cos2 T21. N = 1e6 from each side;
// false-alarm rate 1e-4.
TEST(AllBounces, TransmitReciprocally) {
  const double eta = 1.5, ratio = eta * eta;
  for (float alpha : {0.05f, 0.3f, 0.9f}) {
    Exchange in = exchange(static_cast<float>(eta), alpha, 1000000, 15);
    Exchange out = exchange(static_cast<float>(1 / eta), alpha, 1000000, 16);
    double statistic = 0;
    int pairs = 0;
    for (int i = 0; i < bands; ++i)
      for (int j = 0; j < bands; ++j) {
        double there = in.transmitted[i][j], back = ratio * out.transmitted[j][i];
        // the variance of both under the hypothesis that they agree: those of Poisson counts with a common rate
        double common = (in.transmitted[i][j] + out.transmitted[j][i]) / (1 + ratio); // expected count of `out`
        if (common < 20)
          continue;
        statistic += (there - back) * (there - back) / (ratio * common + ratio * ratio * common);
        ++pairs;
      }
    EXPECT_GT(pairs, 10);
    EXPECT_GT(tyn_test::chi_square_tail(statistic, pairs), 1e-4) << alpha;
  }
}

} // namespace
