// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
// Punctual lights and cameras.
#pragma once

#include "io/gltf_nodes.hpp"
#include "io/gltf_scene.hpp"

namespace tyn::io {

// The light of KHR_lights_punctual that a node carries, if any. Its intensity is taken over unchanged: candela as watt per
// steradian, lux as watt per square metre. (Files written for a photometric renderer want an exposure of about
// log2(1 / 683) stops; most tools write numbers that look right at an exposure of 0.)
void add_light(const tinygltf::Model &model, const PlacedNode &node, LoadedScene &scene, Warnings &warnings);

// The camera that a node carries, if any. Its name is the node's, or else the camera's.
void add_camera(const tinygltf::Model &model, const PlacedNode &node, LoadedScene &scene);

} // namespace tyn::io
