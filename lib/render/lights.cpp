// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
#include "render/lights.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/pi.hpp"
#include "render/alias.hpp"

namespace tyn {
namespace {

double mean_of(const float (&rgb)[3]) { return (double(rgb[0]) + double(rgb[1]) + double(rgb[2])) / 3; }

// Area of the scene's bounding sphere's shadow: what light from infinitely far away falls on.
double scene_cross_section(const TynScene &scene) {
  double diagonal2 = 0;
  for (int k = 0; k < 3; k++)
    diagonal2 += std::pow(double(scene.upper[k]) - double(scene.lower[k]), 2);
  return pi * diagonal2 / 4;
}

double light_power(const TynLight &light, double cross_section) {
  switch (light.type) {
  case TYN_LIGHT_DIRECTIONAL:
    return mean_of(light.intensity) * cross_section;
  case TYN_LIGHT_SPOT:
    return mean_of(light.intensity) * 2 * pi * (1 - std::cos(double(light.outer_cone)));
  default:
    return mean_of(light.intensity) * 4 * pi;
  }
}

TynLightRecord light_record(const TynLight &light) {
  TynLightRecord record{};
  std::copy(light.position, light.position + 3, record.position);
  std::copy(light.direction, light.direction + 3, record.direction);
  std::copy(light.intensity, light.intensity + 3, record.intensity);
  record.type = light.type;
  // KHR_lights_punctual, "Inner and Outer Cone Angles"
  const double inner = std::cos(double(light.inner_cone)), outer = std::cos(double(light.outer_cone));
  const double scale = 1 / std::max(0.001, inner - outer);
  record.angle_scale = float(scale);
  record.angle_offset = float(-outer * scale);
  return record;
}

double triangle_area(const Mesh &mesh, size_t triangle) {
  const auto corner = [&](size_t i) { return mesh.positions[mesh.indices[3 * triangle + i]]; };
  const Vec3 a = corner(0), b = corner(1), c = corner(2);
  const double ux = double(b.x) - double(a.x), uy = double(b.y) - double(a.y), uz = double(b.z) - double(a.z);
  const double vx = double(c.x) - double(a.x), vy = double(c.y) - double(a.y), vz = double(c.z) - double(a.z);
  return 0.5 *
         std::sqrt(std::pow(uy * vz - uz * vy, 2) + std::pow(uz * vx - ux * vz, 2) + std::pow(ux * vy - uy * vx, 2));
}

// Power of one unit of area.
double exitance(const TynMaterial &material) {
  return mean_of(material.emission) * pi * (material.double_sided ? 2 : 1);
}

// Emitters with the weights by which they are chosen.
struct Emitters {
  std::vector<TynEmitterRecord> records;
  std::vector<double> weights;

  void add(uint32_t kind, uint32_t index, double weight) {
    if (!(weight > 0))
      return;
    TynEmitterRecord record{};
    record.kind = kind;
    record.index = index;
    records.push_back(record);
    weights.push_back(weight);
  }
};

void add_triangles(const TynScene &scene, Emitters &emitters) {
  std::vector<double> exitances;
  for (const Named<TynMaterial> &material : scene.materials)
    exitances.push_back(exitance(material.value));
  for (size_t m = 0; m < scene.meshes.size(); m++) {
    const Mesh &mesh = scene.meshes[m];
    for (size_t i = 0; i < mesh.materials.size(); i++) {
      const uint32_t material = mesh.materials[i];
      const double power = material < exitances.size() ? exitances[material] : 0;
      if (power > 0)
        emitters.add(TYN_EMITTER_TRIANGLE, scene.mesh_records[m].first_triangle + uint32_t(i),
                     power * triangle_area(mesh, i));
    }
  }
}

} // namespace

LightTable light_table(const TynScene &scene, double environment_power, std::vector<TynMaterialRecord> &materials) {
  LightTable table;
  Emitters emitters;
  const double cross_section = scene_cross_section(scene);
  for (size_t i = 0; i < scene.lights.size(); i++) {
    table.lights.push_back(light_record(scene.lights[i].value));
    emitters.add(TYN_EMITTER_LIGHT, uint32_t(i), light_power(scene.lights[i].value, cross_section));
  }
  add_triangles(scene, emitters);
  emitters.add(TYN_EMITTER_ENVIRONMENT, 0, environment_power * cross_section);
  if (emitters.records.empty())
    return table;

  const double total = std::accumulate(emitters.weights.begin(), emitters.weights.end(), 0.0);
  const std::vector<AliasRow> rows = alias_table(emitters.weights);
  for (size_t i = 0; i < rows.size(); i++) {
    TynEmitterRecord &record = emitters.records[i];
    record.threshold = rows[i].threshold;
    record.alias = rows[i].alias;
    record.probability = float(emitters.weights[i] / total);
  }
  for (size_t i = 0; i < materials.size(); i++)
    materials[i].emission_density = float(exitance(scene.materials[i].value) / total);
  table.environment_probability = environment_power * cross_section / total;
  table.emitters = std::move(emitters.records);
  return table;
}

} // namespace tyn
