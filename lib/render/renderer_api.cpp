// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
// The renderer's C calls.
#include "render/renderer.hpp"

#include <cstddef>

#include "core/input.hpp"
#include "render/bssrdf_walks.hpp"
#include "scene/validate.hpp"

namespace {

TynRenderOptions checked_options(const TynRenderOptions *given) {
  const TynRenderOptions options =
      given ? tyn::read_struct("TynRenderOptions", given, tyn_render_options(), offsetof(TynRenderOptions, bssrdf))
            : tyn_render_options();
  tyn::require_between("TynRenderOptions::width", options.width, 1, 32768);
  tyn::require_between("TynRenderOptions::height", options.height, 1, 32768);
  tyn::require_between("TynRenderOptions::max_bounces", options.max_bounces, 1, 16777215);
  tyn::require_choice("TynRenderOptions::exit", options.exit, 2);
  tyn::require_size("TynCamera", options.camera.size, sizeof(TynCamera), sizeof(TynCamera));
  tyn::validate(options.camera);
  if (options.bssrdf != TYN_NONE && options.exit == TYN_EXIT_DIELECTRIC)
    tyn::fail(
        TYN_ERROR_INVALID_ARGUMENT,
        "TynRenderOptions::exit is %u (dielectric), a walk's own direction, which TynRenderOptions::bssrdf %u does "
        "not give; it must be %u (diffuse)",
        options.exit, options.bssrdf, TYN_EXIT_DIFFUSE);
  return options;
}

TynRenderBudget checked_budget(const TynRenderBudget *given) {
  const TynRenderBudget budget =
      given ? tyn::read_struct("TynRenderBudget", given, tyn_render_budget()) : tyn_render_budget();
  tyn::require_not_negative("TynRenderBudget::seconds", budget.seconds);
  tyn::require_not_negative("TynRenderBudget::target_error", budget.target_error);
  if (budget.samples == 0 && budget.seconds == 0 && budget.target_error == 0)
    tyn::fail(TYN_ERROR_INVALID_ARGUMENT,
              "samples, seconds and target_error of TynRenderBudget are all 0; at least one must limit the render");
  return budget;
}

} // namespace

extern "C" TynStatus tyn_renderer_create(TynScene *scene, const TynRenderOptions *options, TynRenderer **renderer) {
  if (renderer)
    *renderer = nullptr;
  if (!scene)
    return TYN_ERROR_INVALID_ARGUMENT;
  return tyn::guarded(&scene->context, [&] {
    tyn::require_pointer("renderer", renderer);
    scene->require_committed();
    const TynRenderOptions checked = checked_options(options);
    if (checked.bssrdf != TYN_NONE)
      tyn::require_bssrdf(*scene, checked.bssrdf);
    *renderer = new TynRenderer(*scene, checked);
  });
}

extern "C" void tyn_renderer_retain(TynRenderer *renderer) {
  if (renderer)
    renderer->retain();
}

extern "C" void tyn_renderer_release(TynRenderer *renderer) {
  if (renderer)
    renderer->release();
}

extern "C" TynScene *tyn_renderer_scene(const TynRenderer *renderer) { return renderer ? &renderer->scene : nullptr; }

extern "C" TynStatus tyn_renderer_run(TynRenderer *renderer, const TynRenderBudget *budget) {
  if (!renderer)
    return TYN_ERROR_INVALID_ARGUMENT;
  return tyn::guarded(&renderer->scene.context, [&] { renderer->run(checked_budget(budget)); });
}

extern "C" TynStatus tyn_renderer_read(TynRenderer *renderer, uint32_t layer, float *pixels, size_t count) {
  if (!renderer)
    return TYN_ERROR_INVALID_ARGUMENT;
  return tyn::guarded(&renderer->scene.context, [&] {
    tyn::require_pointer("pixels", pixels);
    tyn::require_choice("layer", layer, TYN_LAYER_COUNT);
    const size_t needed = renderer->film.pixels() * tyn_layer_channels(layer);
    if (count < needed)
      tyn::fail(TYN_ERROR_INVALID_ARGUMENT, "count is %zu; layer \"%s\" has %zu floats", count, tyn_layer_name(layer),
                needed);
    renderer->film.read(layer, pixels);
  });
}

extern "C" TynStatus tyn_renderer_stats(TynRenderer *renderer, TynRenderStats *stats) {
  if (!renderer)
    return TYN_ERROR_INVALID_ARGUMENT;
  return tyn::guarded(&renderer->scene.context, [&] {
    constexpr size_t first_version = offsetof(TynRenderStats, seconds_rays);
    tyn::write_struct("TynRenderStats", stats, renderer->stats(), first_version);
  });
}
