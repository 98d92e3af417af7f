// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
// The random numbers of kernels/random.clh against Random123 (Salmon, Moraes, Dror, Shaw 2011), its known-answer vectors and
// its library.
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include <Random123/philox.h>

#include "core/opencl_shim.hpp"
#include "common/statistics.hpp"

namespace {

using namespace tyn_kernel;

void expect_words(const LaneUint words[4], uint4 expected) {
  EXPECT_EQ(words[0], expected.x);
  EXPECT_EQ(words[1], expected.y);
  EXPECT_EQ(words[2], expected.z);
  EXPECT_EQ(words[3], expected.w);
}

void expect_philox(uint4 counter, uint2 key, uint4 expected) {
  uint4 result = tyn_philox(counter, key);
  LaneUint whole[4] = {result.x, result.y, result.z, result.w};
  expect_words(whole, expected);
  LaneUint lanes[4] = {counter.x, counter.y, counter.z, counter.w};
  lane_philox(lanes, key.x, key.y);
  expect_words(lanes, expected);
}

// The three rows "philox 4x32 10" of Random123's kat_vectors.
TEST(Philox, GivesTheKnownAnswers) {
  const uint ones = 0xffffffffu;
  expect_philox({0, 0, 0, 0}, {0, 0}, {0x6627e8d5u, 0xe169c58du, 0xbc57ac4cu, 0x9b00dbd8u});
  expect_philox({ones, ones, ones, ones}, {ones, ones}, {0x408f276du, 0x41c83b0eu, 0xa20bc7c6u, 0x6d5451fdu});
  expect_philox({0x243f6a88u, 0x85a308d3u, 0x13198a2eu, 0x03707344u}, {0xa4093822u, 0x299f31d0u},
                {0xd16cfe09u, 0x94fdccebu, 0x5001e420u, 0x24126ea1u});
}

TEST(Philox, WithSevenRoundsAgreesWithRandom123) {
  std::mt19937 random(4);
  auto word = [&] { return static_cast<uint>(random()); };
  r123::Philox4x32_R<7> reference;
  for (int i = 0; i < 100000; ++i) {
    LaneUint lanes[4] = {word(), word(), word(), word()};
    uint2 key = {word(), word()};
    r123::Philox4x32_R<7>::ctr_type c = {{lanes[0], lanes[1], lanes[2], lanes[3]}};
    r123::Philox4x32_R<7>::key_type k = {{key.x, key.y}};
    r123::Philox4x32_R<7>::ctr_type expected = reference(c, k);
    lane_philox_rounds(lanes, key.x, key.y, 7);
    for (int w = 0; w < 4; ++w)
      ASSERT_EQ(lanes[w], expected[static_cast<size_t>(w)]);
  }
}

TEST(Philox, AgreesWithRandom123OnAMillionRandomCounters) {
  std::mt19937 random(3);
  auto word = [&] { return static_cast<uint>(random()); };
  r123::Philox4x32 reference;
  for (int i = 0; i < 1000000; ++i) {
    uint4 counter = {word(), word(), word(), word()};
    uint2 key = {word(), word()};
    r123::Philox4x32::ctr_type c = {{counter.x, counter.y, counter.z, counter.w}};
    r123::Philox4x32::key_type k = {{key.x, key.y}};
    r123::Philox4x32::ctr_type expected = reference(c, k);
    uint4 result = tyn_philox(counter, key);
    LaneUint lanes[4] = {counter.x, counter.y, counter.z, counter.w};
    lane_philox(lanes, key.x, key.y);
    ASSERT_TRUE(result.x == expected[0] && result.y == expected[1] && result.z == expected[2] &&
                result.w == expected[3]);
    ASSERT_TRUE(lanes[0] == expected[0] && lanes[1] == expected[1] && lanes[2] == expected[2] &&
                lanes[3] == expected[3]);
  }
}

TEST(Uniform, ExcludesZeroAndOne) {
  EXPECT_EQ(tyn_uniform(0u), 0x1p-24f);
  EXPECT_EQ(tyn_uniform(0xffffffffu), 1.0f - 0x1p-24f);
  EXPECT_EQ(lane_uniform(0u), 0x1p-24f);
  EXPECT_EQ(lane_uniform(0xffffffffu), 1.0f - 0x1p-24f);
}

TEST(Uniform, FineOneExcludesZeroAndReachesFarDown) {
  EXPECT_EQ(lane_uniform_fine(0u), 0x1p-33f);
  EXPECT_EQ(lane_uniform_fine(1u), 0x1p-32f + 0x1p-33f);
  EXPECT_EQ(lane_uniform_fine(0xffffffffu), 1.0f);
}

// N = 4e6 in 1000 bins; false-alarm rate 1e-4.
TEST(Uniform, IsUniformOverPathsDrawsAndWords) {
  std::vector<double> observed(1000), expected(1000, 4000.0);
  for (uint path = 0; path < 10000; ++path)
    for (uint draw = 0; draw < 100; ++draw) {
      uint4 r = tyn_philox(tyn_uint4(path, 0, draw, TYN_DOMAIN_WALK), tyn_uint2(7, 0));
      for (uint bits : {r.x, r.y, r.z, r.w})
        observed[size_t(tyn_uniform(bits) * 1000.0)] += 1;
    }
  EXPECT_GT(tyn_test::chi_square_test(observed, expected), 1e-4);
}

} // namespace
