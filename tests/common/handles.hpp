// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
// Owners for tests: a context, and a scene on it. A missing device is a failure, not a skip.
#pragma once

#include <gtest/gtest.h>

#include "common/meshes.hpp"
#include "tyndall/tyndall.h"

namespace tyn_test {

class Context {
public:
  Context() : Context(tyn_context_options()) {}
  explicit Context(TynContextOptions options) {
    char message[512] = "";
    options.message = message;
    options.message_capacity = sizeof message;
    EXPECT_EQ(tyn_context_create(&options, &handle), TYN_OK) << message;
  }
  ~Context() { tyn_context_release(handle); }
  Context(const Context &) = delete;
  Context &operator=(const Context &) = delete;
  operator TynContext *() const { return handle; }
  std::string message() const { return tyn_context_message(handle); }

private:
  TynContext *handle = nullptr;
};

class Scene {
public:
  explicit Scene(TynContext *context) {
    EXPECT_EQ(tyn_scene_create(context, nullptr, &handle), TYN_OK) << tyn_context_message(context);
  }
  ~Scene() { tyn_scene_release(handle); }
  Scene(const Scene &) = delete;
  Scene &operator=(const Scene &) = delete;
  operator TynScene *() const { return handle; }
  TynScene *operator->() const { return handle; }

  uint32_t add(const MeshData &mesh, uint32_t medium = TYN_NONE, uint32_t material = TYN_NONE) {
    TynMesh view = mesh.view();
    view.medium = medium;
    view.material = material;
    uint32_t index = TYN_NONE;
    EXPECT_EQ(tyn_scene_add_mesh(handle, &view, &index), TYN_OK) << message();
    return index;
  }
  void commit() { ASSERT_EQ(tyn_scene_commit(handle), TYN_OK) << message(); }
  TynMeshInfo info(uint32_t mesh) const {
    TynMeshInfo result{};
    result.size = sizeof result;
    EXPECT_EQ(tyn_scene_mesh_info(handle, mesh, &result), TYN_OK) << message();
    return result;
  }
  TynSceneInfo info() const {
    TynSceneInfo result{};
    result.size = sizeof result;
    EXPECT_EQ(tyn_scene_info(handle, &result), TYN_OK) << message();
    return result;
  }
  std::string message() const { return tyn_context_message(tyn_scene_context(handle)); }

private:
  TynScene *handle = nullptr;
};

} // namespace tyn_test
