// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
#include "scene/scene.hpp"

#include "core/input.hpp"

TynScene::TynScene(TynContext &context_) : context(context_), environment(tyn_environment()) {
  for (int k = 0; k < 3; k++)
    lower[k] = INFINITY, upper[k] = -INFINITY;
  context.retain();
}

TynScene::~TynScene() {
  buffers = tyn::SceneBuffers{}; // they are counted by the context, which may go with this reference
  context.release();
}

void TynScene::retain() { references++; }

void TynScene::release() {
  if (--references == 0)
    delete this;
}

void TynScene::require_open() const {
  if (committed)
    tyn::fail(TYN_ERROR_INVALID_OPERATION, "the scene is committed: it can only be read");
}

void TynScene::require_committed() const {
  if (!committed)
    tyn::fail(TYN_ERROR_INVALID_OPERATION, "the scene is not committed: call tyn_scene_commit first");
}

void TynScene::require_mesh(uint32_t mesh) const { tyn::require_index_or_none("mesh", mesh, meshes.size(), "meshes"); }

uint32_t TynScene::root(uint32_t mesh) const { return mesh == TYN_NONE ? 0 : mesh_records[mesh].root; }

extern "C" {

TynStatus tyn_scene_create(TynContext *context, const TynSceneOptions *options, TynScene **scene) {
  if (scene)
    *scene = nullptr;
  if (!context)
    return TYN_ERROR_INVALID_ARGUMENT;
  return tyn::guarded(context, [&] {
    tyn::require_pointer("scene", scene);
    const TynSceneOptions defaults = tyn_scene_options();
    const TynSceneOptions chosen = options ? tyn::read_struct("TynSceneOptions", options, defaults) : defaults;
    tyn::require_positive("TynSceneOptions::metres_per_unit", chosen.metres_per_unit);
    *scene = new TynScene(*context);
    (*scene)->metres_per_unit = chosen.metres_per_unit;
  });
}

void tyn_scene_retain(TynScene *scene) {
  if (scene)
    scene->retain();
}

void tyn_scene_release(TynScene *scene) {
  if (scene)
    scene->release();
}

TynContext *tyn_scene_context(const TynScene *scene) { return scene ? &scene->context : nullptr; }

} // extern "C"
