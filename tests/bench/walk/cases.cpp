// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
#include "bench/walk/cases.hpp"

#include <algorithm>

namespace bench {

namespace {

using namespace tyn_test;

MeshData sphere(uint32_t frequency) { return bumpy(geodesic_sphere(frequency), 0.2f); }

MeshData shell(uint32_t frequency) {
  MeshData mesh = sphere(frequency);
  mesh.append(inverted(scaled(mesh, 0.9f)));
  return mesh;
}

} // namespace

const std::vector<std::string> &mesh_names() {
  static const std::vector<std::string> names = {"sphere-10k", "sphere-80k", "sphere-600k", "shell", "box"};
  return names;
}

MeshData make_mesh(const std::string &name) {
  if (name == "sphere-10k")
    return sphere(22);
  if (name == "sphere-80k")
    return sphere(64);
  if (name == "sphere-600k")
    return sphere(173);
  if (name == "shell")
    return shell(45);
  return cube();
}

bool Case::same_medium(const Case &other) const {
  return width == other.width && g == other.g && ior == other.ior && albedo == other.albedo;
}

std::vector<Case> all_cases(const Axes &axes) {
  std::vector<Case> cases;
  for (float width : axes.widths)
    for (float g : axes.gs)
      for (float ior : axes.iors)
        for (float albedo : axes.albedos)
          for (const std::string &mesh : axes.meshes)
            cases.push_back({mesh, width, g, ior, albedo});
  return cases;
}

std::vector<Case> few_cases() {
  std::vector<Case> cases = all_cases({});
  auto left_out = [](const Case &c) {
    bool main_mesh = c.mesh == "sphere-80k";
    if (c.albedo != 0.99f)
      return !(main_mesh && c.width == 200 && c.g == 0 && c.ior == 1);
    if (c.ior != 1)
      return c.width != 50 || c.mesh == "sphere-10k" || c.mesh == "sphere-600k";
    return !main_mesh && c.width != 50 && c.width != 200;
  };
  cases.erase(std::remove_if(cases.begin(), cases.end(), left_out), cases.end());
  return cases;
}

} // namespace bench
