// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
#include "io/gltf_medium.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "io/gltf_value.hpp"

namespace tyn::io {
namespace {

void read_color(const tinygltf::Value &object, const char *key, GltfScatter &scatter, Warnings &warnings) {
  double color[3] = {scatter.color[0], scatter.color[1], scatter.color[2]};
  numbers(object, key, color);
  for (int i = 0; i < 3; i++)
    scatter.color[i] = limited(color[i], 0, 1, text("%s.%s[%d]", scatter.where.c_str(), key, i), warnings);
}

// The drafts renamed the colour twice; the newest spelling that is there counts.
void read_color(const tinygltf::Value &object, GltfScatter &scatter, Warnings &warnings) {
  for (const char *key : {"multiscatterColorFactor", "multiscatterColor", "scatterAlbedo"})
    if (member(object, key))
      return read_color(object, key, scatter, warnings);
}

void warn_if_nothing_scatters(const GltfScatter &scatter, Warnings &warnings) {
  const bool black = scatter.color[0] == 0 && scatter.color[1] == 0 && scatter.color[2] == 0;
  if (scatter.strength == 0)
    warnings.add("%s: nothing scatters, because scatterStrengthFactor is 0 (its default)", scatter.where.c_str());
  else if (black)
    warnings.add("%s: nothing scatters, because multiscatterColorFactor is black%s", scatter.where.c_str(),
                 scatter.where.find("volume_scatter") != std::string::npos ? " (its default)" : "");
}

// -ln(color) / distance of one channel.
double extinction(double color, double distance, const std::string &where, Warnings &warnings) {
  constexpr double DARKEST = 1e-6; // a black channel would need an infinite coefficient
  if (std::isinf(distance))
    return 0;
  if (color < DARKEST)
    warnings.add("%s.attenuationColor has a black channel; %g is used", where.c_str(), DARKEST);
  return -std::log(std::min(std::max(color, DARKEST), 1.0)) / distance;
}

} // namespace

float limited(double value, double low, double high, const std::string &where, Warnings &warnings) {
  if (value >= low && value <= high)
    return float(value);
  const double nearest = std::min(std::max(value, low), high);
  warnings.add("%s is %g; it must be in [%g, %g], and %g is used", where.c_str(), value, low, high, nearest);
  return float(nearest);
}

GltfScatter find_scatter(const tinygltf::Material &material, const std::string &where, Warnings &warnings) {
  GltfScatter scatter;
  const tinygltf::Value *newer = extension(material.extensions, "KHR_materials_scatter");
  const tinygltf::Value *older = extension(material.extensions, "KHR_materials_volume_scatter");
  if (!newer && !older)
    return scatter;
  scatter.object = newer ? newer : older;
  scatter.where = where + ".extensions." + (newer ? "KHR_materials_scatter" : "KHR_materials_volume_scatter");
  constexpr double LARGEST_G = 0.999; // +-1 would never turn: the phase function has no density there
  scatter.g = limited(number(*scatter.object, "scatterAnisotropy", 0), -LARGEST_G, LARGEST_G,
                      scatter.where + ".scatterAnisotropy", warnings);
  if (newer)
    scatter.strength =
        limited(number(*newer, "scatterStrengthFactor", 0), 0, 1, scatter.where + ".scatterStrengthFactor", warnings);
  else
    std::fill(scatter.color, scatter.color + 3, 0.0f);
  read_color(*scatter.object, scatter, warnings);
  warn_if_nothing_scatters(scatter, warnings);
  return scatter;
}

TynMedium make_medium(const tinygltf::Value &volume, const GltfScatter &scatter, float ior, const std::string &where,
                      Warnings &warnings) {
  const std::string inside = where + ".extensions.KHR_materials_volume";
  const double distance = number(volume, "attenuationDistance", std::numeric_limits<double>::infinity());
  double color[3] = {1, 1, 1};
  numbers(volume, "attenuationColor", color);
  if (!(distance > 0))
    fail(TYN_ERROR_FORMAT, "%s.attenuationDistance is %g; it must be > 0", inside.c_str(), distance);
  TynMedium medium = tyn_medium();
  medium.ior = ior;
  medium.g = scatter.g;
  for (int i = 0; i < 3; i++) {
    const double c = limited(color[i], 0, 1, text("%s.attenuationColor[%d]", inside.c_str(), i), warnings);
    const float sigma_t = float(extinction(c, distance, inside, warnings));
    if (!std::isfinite(sigma_t))
      fail(TYN_ERROR_FORMAT, "%s: -ln(%g) / %g is too large for single precision", inside.c_str(), c, distance);
    const float reflected = scatter.object ? scatter.strength * scatter.color[i] : 0;
    const float albedo = reflected > 0 ? tyn_albedo_from_color(reflected, scatter.g) : 0; // the fit is not quite 0 at 0
    medium.sigma_s[i] = albedo * sigma_t;
    medium.sigma_a[i] = std::max(sigma_t - medium.sigma_s[i], 0.0f);
  }
  const bool empty = medium.sigma_a[0] + medium.sigma_s[0] + medium.sigma_a[1] + medium.sigma_s[1] + medium.sigma_a[2] +
                         medium.sigma_s[2] ==
                     0;
  if (scatter.object && empty)
    warnings.add("%s: nothing scatters, because attenuationColor is white or attenuationDistance is infinite",
                 inside.c_str());
  return medium;
}

const char *assigned_preset(const TynGltfOptions &options, const std::string &material, bool metal) {
  const char *preset = nullptr;
  for (size_t i = 0; i < options.assignment_count; i++) {
    const TynMediumAssignment &assignment = options.assignments[i];
    const bool all = !assignment.material || std::string(assignment.material) == "ALL";
    if (all ? !metal : material == assignment.material)
      preset = assignment.medium;
  }
  return preset;
}

TynMedium preset_medium(const char *name) {
  TynMedium medium = tyn_medium();
  if (name && tyn_medium_preset(name, 1.0, &medium) == TYN_OK)
    return medium;
  std::string known;
  for (uint32_t i = 0; i < tyn_medium_preset_count(); i++)
    known += std::string(i ? ", " : "") + tyn_medium_preset_name(i);
  fail(TYN_ERROR_INVALID_ARGUMENT, "there is no medium \"%s\"; there are %s", name ? printable(name).c_str() : "NULL",
       known.c_str());
}

void check_assignments(const TynGltfOptions &options, const tinygltf::Model &model) {
  if (options.assignment_count && !options.assignments)
    fail(TYN_ERROR_INVALID_ARGUMENT, "TynGltfOptions::assignments is NULL, but assignment_count is %zu",
         options.assignment_count);
  std::string names;
  for (const tinygltf::Material &material : model.materials)
    names += (names.empty() ? "" : ", ") + material.name;
  for (size_t i = 0; i < options.assignment_count; i++) {
    preset_medium(options.assignments[i].medium);
    const char *name = options.assignments[i].material;
    const bool found = !name || std::string(name) == "ALL" ||
                       std::any_of(model.materials.begin(), model.materials.end(),
                                   [&](const tinygltf::Material &material) { return material.name == name; });
    if (!found)
      fail(TYN_ERROR_INVALID_ARGUMENT, "the model has no material \"%s\"; it has %s", printable(name).c_str(),
           names.empty() ? "none" : printable(names).c_str());
  }
}

} // namespace tyn::io
