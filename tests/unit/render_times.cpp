// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
// Where a renderer says its time went.
#include <cstddef>
#include <vector>

#include <gtest/gtest.h>

#include "common/render_scene.hpp"
#include "tyndall/tyndall_cl.h"

namespace {

using namespace tyn_test;

double measured(const TynRenderStats &s) {
  return s.seconds_rays + s.seconds_walks + s.seconds_exits + s.seconds_shading;
}

// A sphere in even light, opaque or filled with a medium.
void fill(Scene &scene, bool with_medium) {
  TynMaterial material = tyn_material();
  uint32_t material_index = TYN_NONE, medium_index = TYN_NONE;
  if (with_medium) {
    TynMedium medium = tyn_medium();
    for (float &x : medium.sigma_s)
      x = 5;
    ASSERT_EQ(tyn_scene_add_medium(scene, &medium, &medium_index), TYN_OK) << scene.message();
    material.transmission = 1;
  }
  ASSERT_EQ(tyn_scene_add_material(scene, &material, &material_index), TYN_OK) << scene.message();
  scene.add(icosphere(2), medium_index, material_index);
  const TynEnvironment environment = constant_environment(1);
  ASSERT_EQ(tyn_scene_set_environment(scene, &environment), TYN_OK);
  scene.commit();
}

TynRenderOptions options() { return film_options(32, 32, look_at({0, 0, 5}, {0, 0, 0}, {0, 1, 0}, 0.5)); }

TEST(RenderTimes, OfAllKindsAreMeasuredAndAddUpToNoMoreThanTheWhole) {
  Context context;
  Scene scene(context);
  fill(scene, true);
  Render render(scene, options());
  EXPECT_EQ(measured(render.stats()), 0);
  render.run(4);
  const TynRenderStats first = render.stats();
  EXPECT_GT(first.seconds_rays, 0);
  EXPECT_GT(first.seconds_walks, 0);
  EXPECT_GT(first.seconds_exits, 0);
  EXPECT_GT(first.seconds_shading, 0);
  EXPECT_LE(measured(first), 1.001 * first.seconds); // two clocks
  render.run(4);
  const TynRenderStats second = render.stats();
  EXPECT_GT(second.seconds_rays, first.seconds_rays);
  EXPECT_GT(second.seconds_walks, first.seconds_walks);
  EXPECT_GT(second.seconds_exits, first.seconds_exits);
  EXPECT_GT(second.seconds_shading, first.seconds_shading);
  EXPECT_LE(measured(second), 1.001 * second.seconds);
}

TEST(RenderTimes, AreThoseOfTheRendererAlone) {
  Context context;
  Scene scene(context);
  fill(scene, true);
  Render render(scene, options()), other(scene, options());
  render.run(2);
  const double before = measured(render.stats());
  other.run(2);
  TynWalkEntry entry = {};
  entry.kind = TYN_ENTRY_COSINE;
  entry.medium = TYN_NONE;
  entry.albedo[0] = entry.sigma_t[0] = -1;
  TynWalkExit exit = {};
  ASSERT_EQ(tyn_walk(scene, nullptr, &entry, 1, &exit, nullptr), TYN_OK) << scene.message();
  EXPECT_EQ(measured(render.stats()), before);
}

TEST(RenderTimes, OfWalksAreZeroWithoutMedia) {
  Context context;
  Scene scene(context);
  fill(scene, false);
  Render render(scene, options());
  render.run(2);
  const TynRenderStats stats = render.stats();
  EXPECT_GT(stats.seconds_rays, 0);
  EXPECT_EQ(stats.seconds_walks, 0);
  EXPECT_EQ(stats.seconds_exits, 0);
  EXPECT_GT(stats.seconds_shading, 0);
}

TEST(RenderTimes, OnTheCallersQueueAreKnownIfItMeasures) {
  Context own; // for an OpenCL context and a device
  cl_context cl = nullptr;
  cl_device_id device = nullptr;
  ASSERT_EQ(tyn_context_cl(own, &cl, nullptr, &device), TYN_OK);
  for (const cl_command_queue_properties properties : {0, CL_QUEUE_PROFILING_ENABLE}) {
    cl_command_queue queue = clCreateCommandQueue(cl, device, properties, nullptr);
    ASSERT_NE(queue, nullptr);
    TynContext *context = nullptr;
    EXPECT_EQ(tyn_context_create_cl(nullptr, cl, queue, &context), TYN_OK);
    clReleaseCommandQueue(queue);
    ASSERT_NE(context, nullptr);
    {
      Scene scene(context);
      fill(scene, true);
      Render render(scene, options());
      render.run(2);
      EXPECT_EQ(measured(render.stats()) > 0, properties != 0);
      EXPECT_GT(render.stats().seconds, 0);
    }
    tyn_context_release(context);
  }
}

TEST(RenderTimes, AreLeftOutOfTheFirstVersionsStatistics) {
  Context context;
  Scene scene(context);
  fill(scene, false);
  Render render(scene, options());
  render.run(1);
  TynRenderStats stats{};
  stats.size = offsetof(TynRenderStats, seconds_rays);
  stats.seconds_rays = -1;
  ASSERT_EQ(tyn_renderer_stats(render, &stats), TYN_OK) << render.message();
  EXPECT_EQ(stats.samples, 1u);
  EXPECT_EQ(stats.size, offsetof(TynRenderStats, seconds_rays));
  EXPECT_EQ(stats.seconds_rays, -1) << "beyond the caller's struct nothing is written";
  stats.size--;
  EXPECT_EQ(tyn_renderer_stats(render, &stats), TYN_ERROR_INVALID_ARGUMENT);
}

} // namespace
