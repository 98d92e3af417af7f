// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
//
// Tyndall for C++11: owners for the handles and exceptions for the statuses, over the same calls. Everything else is the C
// API, which takes the owners where it takes handles through get().
//
//   tyndall::Context context;
//   tyndall::Scene scene(context);
//   context.check(tyn_scene_add_mesh(scene.get(), &mesh, nullptr));
#ifndef TYNDALL_HPP
#define TYNDALL_HPP

#include <stdexcept>
#include <string>

#include "tyndall.h"

namespace tyndall {

// What a call that failed says: its status and the context's message.
class Error : public std::runtime_error {
public:
  Error(TynStatus status, const std::string &message) : std::runtime_error(message), status_(status) {}
  TynStatus status() const { return status_; }

private:
  TynStatus status_;
};

// One reference to a handle: copying retains, destruction releases. Handle functions are template arguments, so an owner is
// the size of a pointer.
template <class T, void (*retain)(T *), void (*release)(T *)>
class Owner {
public:
  Owner() : handle_(nullptr) {}
  // Takes over the reference that a *_create call returned.
  explicit Owner(T *handle) : handle_(handle) {}
  Owner(const Owner &other) : handle_(other.handle_) { retain(handle_); }
  Owner(Owner &&other) noexcept : handle_(other.handle_) { other.handle_ = nullptr; }
  Owner &operator=(Owner other) noexcept {
    T *handle = handle_;
    handle_ = other.handle_;
    other.handle_ = handle;
    return *this;
  }
  ~Owner() { release(handle_); }

  T *get() const { return handle_; }
  explicit operator bool() const { return handle_ != nullptr; }

private:
  T *handle_;
};

// Throws an Error with the context's message unless `status` is TYN_OK.
inline void check(const TynContext *context, TynStatus status) {
  if (status == TYN_OK)
    return;
  std::string message = context ? tyn_context_message(context) : "";
  throw Error(status, message.empty() ? tyn_status_string(status) : message);
}

class Context : public Owner<TynContext, tyn_context_retain, tyn_context_release> {
public:
  Context() : Context(tyn_context_options()) {}
  // `options.message` is used here; its value does not matter.
  explicit Context(TynContextOptions options) : Owner(create(options)) {}
  void check(TynStatus status) const { tyndall::check(get(), status); }

private:
  static TynContext *create(TynContextOptions options) {
    char message[4096] = "";
    options.message = message;
    options.message_capacity = sizeof message;
    TynContext *context = nullptr;
    TynStatus status = tyn_context_create(&options, &context);
    if (status != TYN_OK)
      throw Error(status, message);
    return context;
  }
};

class Scene : public Owner<TynScene, tyn_scene_retain, tyn_scene_release> {
public:
  explicit Scene(const Context &context) : Scene(context, tyn_scene_options()) {}
  Scene(const Context &context, const TynSceneOptions &options) : Owner(create(context, options)) {}
  void check(TynStatus status) const { tyndall::check(tyn_scene_context(get()), status); }

private:
  static TynScene *create(const Context &context, const TynSceneOptions &options) {
    TynScene *scene = nullptr;
    context.check(tyn_scene_create(context.get(), &options, &scene));
    return scene;
  }
};

class Renderer : public Owner<TynRenderer, tyn_renderer_retain, tyn_renderer_release> {
public:
  Renderer(const Scene &scene, const TynRenderOptions &options) : Owner(create(scene, options)) {}
  void check(TynStatus status) const { tyndall::check(tyn_scene_context(tyn_renderer_scene(get())), status); }

private:
  static TynRenderer *create(const Scene &scene, const TynRenderOptions &options) {
    TynRenderer *renderer = nullptr;
    scene.check(tyn_renderer_create(scene.get(), &options, &renderer));
    return renderer;
  }
};

} // namespace tyndall

#endif
