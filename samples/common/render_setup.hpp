// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
//
// What a scene needs before it can be rendered, and what is assumed where the file says nothing.
#pragma once

#include "common/render_arguments.hpp"

namespace tool {

// The camera and the size of the film.
struct View {
  TynCamera camera;
  std::string name; // of the file's camera; empty: framed
  uint32_t width, height;
};

// The camera asked for, else the file's first, else one that frames the scene.
View choose_view(const TynScene *scene, const RenderArguments &arguments);

enum class Lighting {
  kScene,   // the file's own, or the environment asked for
  kDefault, // nothing lit the scene: a soft default light was added
  kNone     // nothing lights the scene, as asked
};

// Sets the environment, or a default light if there is no other. The default light comes from beside the camera.
Lighting set_lighting(TynScene *scene, const RenderArguments &arguments, const TynCamera &camera);

} // namespace tool
