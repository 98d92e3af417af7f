// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
// What a mesh is: closed or not, how it is oriented, how large. Nothing found here is fatal.
#pragma once

#include "scene/scene.hpp"

namespace tyn {

// Fills in mesh.info (but for name, medium and material), and turns triangles (exchanges their second and third
// vertex) so that neighbours agree and a closed mesh encloses a positive volume. Normals that point inwards are
// turned with it.
void check_mesh(Mesh &mesh);

} // namespace tyn
