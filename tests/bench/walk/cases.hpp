// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
// What bench-walk measures: meshes by name, and media in them.
#pragma once

#include <string>
#include <vector>

#include "common/meshes.hpp"

namespace bench {

// All about 2 across. "shell" is what is between two bumpy spheres, a twentieth of the width apart.
const std::vector<std::string> &mesh_names();
tyn_test::MeshData make_mesh(const std::string &name);

struct Case {
  std::string mesh;
  float width; // mean free paths across the mesh
  float g, ior, albedo;

  float sigma_t() const { return width / 2; }
  bool same_medium(const Case &other) const;
};

// Values to go through, each with each.
struct Axes {
  std::vector<std::string> meshes = mesh_names();
  std::vector<float> widths = {20, 50, 200, 1000}, gs = {0, 0.8f}, iors = {1, 1.4f}, albedos = {0.95f, 0.99f, 0.999f};
};

// Medium by medium, so that meshes are compared under the same load of the machine.
std::vector<Case> all_cases(const Axes &axes);
// Few of the above that show how each value matters.
std::vector<Case> few_cases();

} // namespace bench
