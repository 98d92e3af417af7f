// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
// A BSSRDF model in place of walks: the profiles of a scene's media over a range of albedos, and their kernel's launch.
#pragma once

#include <memory>

#include "bssrdf/bssrdf.hpp"
#include "kernels/shared_render.h"
#include "scene/scene.hpp"

namespace tyn {

// Throws INVALID_ARGUMENT if `model` is none, or one that the renderer cannot use, or for the media of a scene's meshes.
void require_bssrdf(const TynScene &scene, uint32_t model);

class BssrdfWalks {
public:
  // Prepares a model for all media that meshes hold: some seconds where albedos come from textures, or where the exact model
  // makes a table; meanwhile `progress`, which may be NULL, hears 0. Throws.
  BssrdfWalks(TynScene &scene, uint32_t model, TynProgress progress, void *user);

  // As enqueue_walk: for `count` entries of the shade kernel. Does not wait.
  void enqueue(const TynRenderParameters &parameters, uint32_t count, cl_mem entries, cl_mem exits, cl_mem tallies);

private:
  struct Release {
    void operator()(TynBssrdf *bssrdf) const { bssrdf->release(); }
  };

  TynScene &scene;
  std::unique_ptr<TynBssrdf, Release> profiles; // of all media, one after the other
  Buffer families;                              // TynProfileFamily of each medium
  Buffer nodes;                                 // float: see TynProfileFamily
};

} // namespace tyn
