// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
// How a surface is cut into triangles does not matter, only where it is.
#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "common/statistics.hpp"
#include "common/walk_scene.hpp"
#include "core/pi.hpp"
#include "scene/scene.hpp"

namespace {

using namespace tyn_test;

TynMedium coloured_medium(float ior) { return rgb_medium({0.05f, 0.2f, 1}, {3, 2, 5}, 0.5f, ior); }

// Anywhere in the box, in any direction.
std::vector<TynWalkEntry> inner_entries(const TynMeshInfo &info, size_t count) {
  std::mt19937 random(61);
  std::uniform_real_distribution<float> uniform(-1, 1);
  std::vector<TynWalkEntry> entries(count, plain_entry(TYN_ENTRY_INSIDE));
  for (TynWalkEntry &entry : entries) {
    for (int k = 0; k < 3; ++k)
      entry.position[k] = 0.999f * info.upper[k] * uniform(random);
    const double z = double(uniform(random)), angle = tyn::pi * double(uniform(random)), r = std::sqrt(1 - z * z);
    entry.direction[0] = float(r * std::cos(angle));
    entry.direction[1] = float(r * std::sin(angle));
    entry.direction[2] = float(z);
  }
  return entries;
}

// Whether two walks are one, but for how the last digits of their exit were rounded.
bool same_walk(const TynWalkExit &a, const TynWalkExit &b, float near) {
  bool same = a.status == b.status && a.scatterings == b.scatterings;
  for (int k = 0; k < 3; ++k)
    same = same && std::abs(a.position[k] - b.position[k]) <= near && std::abs(a.weight[k] - b.weight[k]) <= 1e-4f &&
           std::abs(a.direction[k] - b.direction[k]) <= 1e-4f && a.geometric_normal[k] == b.geometric_normal[k];
  return same;
}

// 64 triangles for every one: midpoints of edges whose lengths are powers of two are exact, so the surface is the same, and
// with it the walks, one by one. Only rounding of where a ray hits differs. It parts walks that come that near to a choice they
// make, as at the critical angle, and light refracted next to that angle: 1 in 100 000 without a boundary, 1 in 1000 may with one.
TEST(WalkTessellation, ABoxOf768TrianglesGivesTheWalksOfOneOf12) {
  const MeshData coarse = box(2, 1, 4), fine = subdivided(subdivided(subdivided(coarse)));
  ASSERT_EQ(fine.triangle_count(), 64 * coarse.triangle_count());
  for (float ior : {1.0f, 1.4f}) {
    SceneHandle scenes[2] = {make_scene(shared_context(), coarse, coloured_medium(ior)),
                             make_scene(shared_context(), fine, coloured_medium(ior))};
    const std::vector<TynWalkEntry> entries = inner_entries(mesh_info(scenes[0].get()), 400000);
    const Walked few = walk(scenes[0].get(), entries), many = walk(scenes[1].get(), entries);
    EXPECT_EQ(few.ledger.leaked_walks + many.ledger.leaked_walks, 0u);
    EXPECT_EQ(few.ledger.lost_walks + many.ledger.lost_walks, 0u);
    size_t parted = 0, scattered = 0;
    for (size_t i = 0; i < entries.size(); ++i) {
      parted += !same_walk(few.exits[i], many.exits[i], 2 * scenes[0]->mesh_records[0].slack);
      scattered += few.exits[i].scatterings > 2;
    }
    EXPECT_LE(parted, ior == 1 ? 4 : entries.size() / 1000);
    EXPECT_GT(scattered, entries.size() / 4);
    printf("ior %.1f: %zu of %zu walks part\n", double(ior), parted, entries.size());
  }
}

// A sphere of `level`, scaled to the mean chord 4 V / S of a unit sphere.
MeshData sphere(uint32_t level) {
  const MeshData unit = icosphere(level);
  return icosphere(level, float(unit.area() / unit.volume() / 3));
}

struct Escaped {
  Mean weight;
  uint64_t leaked = 0;
};

Escaped escaped_from_sphere(uint32_t level, float ior) {
  const MeshData mesh = sphere(level);
  SceneHandle scene = make_scene(shared_context(), mesh, grey_medium(0.2f, 2, 0.5f, ior));
  Escaped result;
  for (uint32_t batch = 0; batch < 5; ++batch) {
    TynWalkOptions options = tyn_walk_options();
    options.seed = level;
    options.first_path = batch * 200000u;
    const Walked walked = walk(scene.get(), surface_entries(mesh, 200000, 10 * level + batch), options);
    result.leaked += walked.ledger.leaked_walks;
    for (const TynWalkExit &exit : walked.exits)
      result.weight.add(exit.status == TYN_WALK_ESCAPED ? double(exit.weight[0]) : 0);
  }
  return result;
}

// Spheres of 320, 1280 and 20480 triangles against one of 81920. Their surfaces are 1.3 % of the radius off at most at level 2,
// and a fourth of that with every level. With the mean chord the same, the chords still are not distributed alike: of light that
// is only absorbed, 1.3e-4 more get through at level 2 than by the sphere's closed form, and a fourth of that with every
// level. Paths are longer here, and 4e-4 and its fourths are allowed on top of four standard errors. A dielectric sphere keeps
// light for good where it is smooth, which facets tilted by 9 degrees let out: 4e-3. Without the scale to the mean chord, level
// 2 would be beyond either. N = 1e6 each; 2 x 3 comparisons, false alarms 4e-4 in all.
TEST(WalkTessellation, SpheresOfEqualMeanChordAgree) {
  for (float ior : {1.0f, 1.4f}) {
    const Escaped finest = escaped_from_sphere(6, ior);
    EXPECT_EQ(finest.leaked, 0u);
    for (uint32_t level : {2u, 3u, 5u}) {
      const Escaped other = escaped_from_sphere(level, ior);
      EXPECT_EQ(other.leaked, 0u);
      const Mean &a = other.weight, &b = finest.weight;
      const double error = std::hypot(a.standard_error(), b.standard_error());
      EXPECT_NEAR(a.mean(), b.mean(), four_sigma * error + (ior == 1 ? 4e-4 : 4e-3) * std::pow(4.0, 2 - double(level)))
          << "level " << level;
      EXPECT_LT(error, 4e-4) << "too few walks to say anything";
      printf("ior %.1f level %u: %.4f, %+.1e off, %+.1f standard errors\n", double(ior), level, a.mean(),
             a.mean() - b.mean(), (a.mean() - b.mean()) / error);
    }
  }
}

} // namespace
