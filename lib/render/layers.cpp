// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
#include "tyndall/tyndall.h"

namespace {

struct Layer {
  const char *name;
  uint32_t channels;
};

// In the order of TYN_LAYER_*.
constexpr Layer layers[TYN_LAYER_COUNT] = {
    {"beauty", 4}, {"subsurface", 3}, {"specular", 3}, {"diffuse", 3}, {"emission", 3},
    {"albedo", 3}, {"normal", 3},     {"depth", 1},    {"samples", 1}, {"variance", 3},
};

} // namespace

extern "C" const char *tyn_layer_name(uint32_t layer) { return layer < TYN_LAYER_COUNT ? layers[layer].name : nullptr; }

extern "C" uint32_t tyn_layer_channels(uint32_t layer) { return layer < TYN_LAYER_COUNT ? layers[layer].channels : 0; }
