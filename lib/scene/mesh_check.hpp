// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
// What a mesh is: closed or not, how it is oriented, how large. Nothing found here is fatal.
#pragma once

#include "scene/scene.hpp"

namespace tyn {

// Fills in mesh.info (but for name, medium and material). Of a mesh with a medium, it also turns triangles (exchanges
// their second and third vertex) so that neighbours agree and closed components face outwards, and cavities inside them
// inwards. Normals that point the other way are turned with a component.
void check_mesh(Mesh &mesh);

} // namespace tyn
