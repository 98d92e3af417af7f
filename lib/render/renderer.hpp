// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
// A scene, a camera and a film that grows.
#pragma once

#include <atomic>
#include <memory>

#include "render/bssrdf_walks.hpp"
#include "render/film.hpp"
#include "render/ledger.hpp"
#include "render/tables.hpp"
#include "render/times.hpp"
#include "scene/scene.hpp"

struct TynRenderer {
  // `options` have been checked. `strategy`: TYN_STRATEGY_*. Throws.
  TynRenderer(TynScene &scene, const TynRenderOptions &options, uint32_t strategy = TYN_STRATEGY_MIS);
  void retain();
  void release();

  void run(const TynRenderBudget &budget);
  TynRenderStats stats() const;

  TynScene &scene; // retained
  const TynRenderOptions options;
  // Paths a pass may have at most; tests lower it. Changes no bit of the image.
  size_t largest_pass;

  tyn::Film film;

private:
  ~TynRenderer();

  TynRenderParameters parameters() const;

  const uint32_t strategy;
  const tyn::SceneTables tables;
  const TynCameraRecord camera;
  std::unique_ptr<tyn::BssrdfWalks> bssrdf; // in place of walks; made by the first run
  tyn::RenderLedger ledger;
  tyn::RenderTimes times;
  uint32_t samples = 0;    // that every pixel has
  uint64_t next_pixel = 0; // pixels before it have one sample more
  uint64_t nonfinite_paths = 0;
  double seconds = 0;
  std::atomic<uint32_t> references{1};
};
