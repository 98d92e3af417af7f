// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
#include "common/handles.hpp"

using namespace tyn_test;

namespace {

TEST(KernelsChecked, IntersectAndOccluded) {
  Context context;
  Scene scene(context);
  TynMedium medium = tyn_medium();
  uint32_t inside = TYN_NONE;
  ASSERT_EQ(tyn_scene_add_medium(scene, &medium, &inside), TYN_OK) << context.message();
  scene.add(with_flipped(icosphere(0), 3), inside);
  scene.add(translated(cube(), 3, 0, 0));
  scene.commit();
  std::vector<TynRay> rays; // a count that is no multiple of anything
  for (int i = 0; i < 7; i++)
    rays.push_back({{-5, 0.1f * float(i), 0.25f}, 0, {1, 0, 0}, 100});
  rays.push_back({{0, 5, 0}, 0, {0, 1, 0}, 100}); // a miss
  rays.push_back({{0, 0, 0}, 0, {0, 0.6f, 0.8f}, 100});
  std::vector<TynHit> hits(rays.size());
  std::vector<uint32_t> occluded(rays.size());
  ASSERT_EQ(tyn_intersect(scene, TYN_NONE, rays.data(), rays.size(), hits.data()), TYN_OK) << context.message();
  ASSERT_EQ(tyn_occluded(scene, 0, rays.data(), rays.size(), occluded.data()), TYN_OK) << context.message();
  EXPECT_EQ(hits[0].mesh, 0u);
  EXPECT_EQ(hits[7].mesh, TYN_NONE);
  EXPECT_EQ(occluded[7], 0u);
  EXPECT_EQ(hits[8].mesh, 0u);
}

} // namespace
