// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
// Host and device must agree on every record that both read: a kernel made from the embedded sources reports its sizes and
// offsets. The records and their fields are found in those sources, so that none can be forgotten here.
#include <cstddef>
#include <map>
#include <regex>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "common/walk_scene.hpp"
#include "core/context.hpp"
#include "core/kernels.hpp"
#include "kernels/shared.h"
#include "kernels/shared_render.h"
#include "kernels/shared_bssrdf.h"
#include "kernels/shared_slab.h"

namespace {

// "Record" and its size, or "Record.field" and its offset.
using Layout = std::map<std::string, size_t>;

#define RECORD(type)                                                                                                   \
  { #type, sizeof(type) }
#define FIELD(type, field)                                                                                             \
  { #type "." #field, offsetof(type, field) }

const Layout &host_layout() {
  static const Layout layout = {
      // clang-format off
      RECORD(TynRay),
      FIELD(TynRay, origin), FIELD(TynRay, t_min), FIELD(TynRay, direction), FIELD(TynRay, t_max),

      RECORD(TynHit),
      FIELD(TynHit, t), FIELD(TynHit, u), FIELD(TynHit, v), FIELD(TynHit, mesh),
      FIELD(TynHit, triangle), FIELD(TynHit, normal),

      RECORD(TynWalkEntry),
      FIELD(TynWalkEntry, position), FIELD(TynWalkEntry, kind), FIELD(TynWalkEntry, direction),
      FIELD(TynWalkEntry, mesh), FIELD(TynWalkEntry, weight), FIELD(TynWalkEntry, triangle),
      FIELD(TynWalkEntry, albedo), FIELD(TynWalkEntry, medium), FIELD(TynWalkEntry, sigma_t),
      FIELD(TynWalkEntry, reserved), FIELD(TynWalkEntry, roughness), FIELD(TynWalkEntry, path),
      FIELD(TynWalkEntry, reserved2),

      RECORD(TynWalkExit),
      FIELD(TynWalkExit, position), FIELD(TynWalkExit, status), FIELD(TynWalkExit, direction),
      FIELD(TynWalkExit, triangle), FIELD(TynWalkExit, weight), FIELD(TynWalkExit, scatterings),
      FIELD(TynWalkExit, geometric_normal), FIELD(TynWalkExit, path_length),
      FIELD(TynWalkExit, shading_normal), FIELD(TynWalkExit, u), FIELD(TynWalkExit, uv),
      FIELD(TynWalkExit, v), FIELD(TynWalkExit, reserved),

      RECORD(TynBssrdfPath),
      FIELD(TynBssrdfPath, entry_position), FIELD(TynBssrdfPath, entry_normal),
      FIELD(TynBssrdfPath, entry_direction), FIELD(TynBssrdfPath, exit_position),
      FIELD(TynBssrdfPath, exit_normal), FIELD(TynBssrdfPath, exit_direction),

      RECORD(TynBssrdfEntry),
      FIELD(TynBssrdfEntry, position), FIELD(TynBssrdfEntry, mesh), FIELD(TynBssrdfEntry, normal),
      FIELD(TynBssrdfEntry, reserved), FIELD(TynBssrdfEntry, path), FIELD(TynBssrdfEntry, reserved2),

      RECORD(TynBssrdfExit),
      FIELD(TynBssrdfExit, position), FIELD(TynBssrdfExit, status), FIELD(TynBssrdfExit, geometric_normal),
      FIELD(TynBssrdfExit, triangle), FIELD(TynBssrdfExit, shading_normal), FIELD(TynBssrdfExit, hits),
      FIELD(TynBssrdfExit, u), FIELD(TynBssrdfExit, v), FIELD(TynBssrdfExit, uv), FIELD(TynBssrdfExit, distance),
      FIELD(TynBssrdfExit, pdf), FIELD(TynBssrdfExit, reserved),

      RECORD(TynBvhNode),
      FIELD(TynBvhNode, bounds), FIELD(TynBvhNode, child),

      RECORD(TynTriangleBlock),
      FIELD(TynTriangleBlock, position), FIELD(TynTriangleBlock, triangle),

      RECORD(TynTriangleRecord),
      FIELD(TynTriangleRecord, vertex), FIELD(TynTriangleRecord, mesh),
      FIELD(TynTriangleRecord, material), FIELD(TynTriangleRecord, horizon),

      RECORD(TynMeshRecord),
      FIELD(TynMeshRecord, root), FIELD(TynMeshRecord, first_triangle),
      FIELD(TynMeshRecord, triangle_count), FIELD(TynMeshRecord, medium), FIELD(TynMeshRecord, flags),
      FIELD(TynMeshRecord, slack), FIELD(TynMeshRecord, lower), FIELD(TynMeshRecord, upper),
      FIELD(TynMeshRecord, grid_first), FIELD(TynMeshRecord, grid_size), FIELD(TynMeshRecord, grid_cell),
      FIELD(TynMeshRecord, grid_per_cell), FIELD(TynMeshRecord, grid_step),
      FIELD(TynMeshRecord, local_first), FIELD(TynMeshRecord, local_size), FIELD(TynMeshRecord, local_cell),
      FIELD(TynMeshRecord, local_per_cell), FIELD(TynMeshRecord, horizon_reach),

      RECORD(TynMediumRecord),
      FIELD(TynMediumRecord, sigma_t), FIELD(TynMediumRecord, g), FIELD(TynMediumRecord, albedo),
      FIELD(TynMediumRecord, ior), FIELD(TynMediumRecord, phase), FIELD(TynMediumRecord, reserved),

      RECORD(TynPhaseRecord),
      FIELD(TynPhaseRecord, kind), FIELD(TynPhaseRecord, g), FIELD(TynPhaseRecord, g2),
      FIELD(TynPhaseRecord, weight), FIELD(TynPhaseRecord, alpha), FIELD(TynPhaseRecord, table),
      FIELD(TynPhaseRecord, count), FIELD(TynPhaseRecord, reserved),

      RECORD(TynWalkParameters),
      FIELD(TynWalkParameters, seed), FIELD(TynWalkParameters, first_path),
      FIELD(TynWalkParameters, count), FIELD(TynWalkParameters, max_scatterings),
      FIELD(TynWalkParameters, roulette_threshold), FIELD(TynWalkParameters, mesh_count),
      FIELD(TynWalkParameters, medium_count),
      FIELD(TynWalkParameters, slice), FIELD(TynWalkParameters, callers_winding),

      RECORD(TynWalkTally),
      FIELD(TynWalkTally, reflected), FIELD(TynWalkTally, absorbed), FIELD(TynWalkTally, balance),
      FIELD(TynWalkTally, rays),

      RECORD(TynImageRecord),
      FIELD(TynImageRecord, width), FIELD(TynImageRecord, height), FIELD(TynImageRecord, format),
      FIELD(TynImageRecord, first),

      RECORD(TynTextureRecord),
      FIELD(TynTextureRecord, image), FIELD(TynTextureRecord, wrap_u),
      FIELD(TynTextureRecord, wrap_v), FIELD(TynTextureRecord, filter),
      FIELD(TynTextureRecord, transform),

      RECORD(TynMaterialRecord),
      FIELD(TynMaterialRecord, base_color), FIELD(TynMaterialRecord, metallic),
      FIELD(TynMaterialRecord, emission), FIELD(TynMaterialRecord, roughness),
      FIELD(TynMaterialRecord, multiscatter_color), FIELD(TynMaterialRecord, transmission),
      FIELD(TynMaterialRecord, thin_color), FIELD(TynMaterialRecord, thin_scatter),
      FIELD(TynMaterialRecord, thin_forward), FIELD(TynMaterialRecord, ior),
      FIELD(TynMaterialRecord, transmittance), FIELD(TynMaterialRecord, emission_density),
      FIELD(TynMaterialRecord, normal_scale), FIELD(TynMaterialRecord, scatter_strength),
      FIELD(TynMaterialRecord, flags), FIELD(TynMaterialRecord, textures),

      RECORD(TynRenderMedium),
      FIELD(TynRenderMedium, color), FIELD(TynRenderMedium, transmittance),

      RECORD(TynEmitterRecord),
      FIELD(TynEmitterRecord, kind), FIELD(TynEmitterRecord, index),
      FIELD(TynEmitterRecord, threshold), FIELD(TynEmitterRecord, alias),
      FIELD(TynEmitterRecord, probability),

      RECORD(TynLightRecord),
      FIELD(TynLightRecord, position), FIELD(TynLightRecord, type), FIELD(TynLightRecord, direction),
      FIELD(TynLightRecord, angle_scale), FIELD(TynLightRecord, intensity),
      FIELD(TynLightRecord, angle_offset),

      RECORD(TynEnvironmentTexel),
      FIELD(TynEnvironmentTexel, threshold), FIELD(TynEnvironmentTexel, alias),
      FIELD(TynEnvironmentTexel, density),

      RECORD(TynCameraRecord),
      FIELD(TynCameraRecord, world_from_camera), FIELD(TynCameraRecord, half_width),
      FIELD(TynCameraRecord, half_height), FIELD(TynCameraRecord, znear),
      FIELD(TynCameraRecord, type),

      RECORD(TynRenderParameters),
      FIELD(TynRenderParameters, seed), FIELD(TynRenderParameters, width),
      FIELD(TynRenderParameters, height), FIELD(TynRenderParameters, first_pixel),
      FIELD(TynRenderParameters, pixel_count), FIELD(TynRenderParameters, first_sample),
      FIELD(TynRenderParameters, sample_count), FIELD(TynRenderParameters, max_bounces),
      FIELD(TynRenderParameters, exit), FIELD(TynRenderParameters, strategy),
      FIELD(TynRenderParameters, emitter_count), FIELD(TynRenderParameters, environment),
      FIELD(TynRenderParameters, environment_image), FIELD(TynRenderParameters, environment_cos),
      FIELD(TynRenderParameters, environment_sin),
      FIELD(TynRenderParameters, environment_probability),
      FIELD(TynRenderParameters, environment_hidden),

      RECORD(TynPathState),
      FIELD(TynPathState, origin), FIELD(TynPathState, t_min), FIELD(TynPathState, direction),
      FIELD(TynPathState, pdf), FIELD(TynPathState, throughput), FIELD(TynPathState, bounces),
      FIELD(TynPathState, t), FIELD(TynPathState, u), FIELD(TynPathState, v),
      FIELD(TynPathState, triangle), FIELD(TynPathState, event), FIELD(TynPathState, cos_axis),
      FIELD(TynPathState, reserved),

      RECORD(TynPathResult),
      FIELD(TynPathResult, light), FIELD(TynPathResult, albedo), FIELD(TynPathResult, depth),
      FIELD(TynPathResult, normal), FIELD(TynPathResult, reserved),

      RECORD(TynShadowRay),
      FIELD(TynShadowRay, origin), FIELD(TynShadowRay, t_max), FIELD(TynShadowRay, direction),
      FIELD(TynShadowRay, path), FIELD(TynShadowRay, first), FIELD(TynShadowRay, first_event),
      FIELD(TynShadowRay, second), FIELD(TynShadowRay, second_event),

      RECORD(TynProfileRecord),
      FIELD(TynProfileRecord, kind),
      FIELD(TynProfileRecord, first),
      FIELD(TynProfileRecord, count),
      FIELD(TynProfileRecord, chances),
      FIELD(TynProfileRecord, length),
      FIELD(TynProfileRecord, per_length),
      FIELD(TynProfileRecord, per_area),
      FIELD(TynProfileRecord, falloff),
      FIELD(TynProfileRecord, flux),
      FIELD(TynProfileRecord, fluence),
      FIELD(TynProfileRecord, albedo),
      FIELD(TynProfileRecord, chance),
      FIELD(TynProfileRecord, ior),
      FIELD(TynProfileRecord, exit_ior),
      FIELD(TynProfileRecord, lobe),
      FIELD(TynProfileRecord, directions),
      FIELD(TynProfileRecord, more),
      FIELD(TynProfileRecord, reach),

      RECORD(TynProfileFamily),
      FIELD(TynProfileFamily, first),
      FIELD(TynProfileFamily, count),

      RECORD(TynSlabLayerRecord),
      FIELD(TynSlabLayerRecord, mean_free_path), FIELD(TynSlabLayerRecord, albedo), FIELD(TynSlabLayerRecord, g),
      FIELD(TynSlabLayerRecord, top), FIELD(TynSlabLayerRecord, thickness), FIELD(TynSlabLayerRecord, ior),
      FIELD(TynSlabLayerRecord, general), FIELD(TynSlabLayerRecord, absorption),

      RECORD(TynSlabParameters),
      FIELD(TynSlabParameters, seed), FIELD(TynSlabParameters, first_photon), FIELD(TynSlabParameters, count),
      FIELD(TynSlabParameters, batch), FIELD(TynSlabParameters, slice), FIELD(TynSlabParameters, batch_items), FIELD(TynSlabParameters, flags), FIELD(TynSlabParameters, layer_count),
      FIELD(TynSlabParameters, max_order), FIELD(TynSlabParameters, roulette_threshold),
      FIELD(TynSlabParameters, ior_above), FIELD(TynSlabParameters, ior_below), FIELD(TynSlabParameters, start),
      FIELD(TynSlabParameters, beam), FIELD(TynSlabParameters, beam_radius), FIELD(TynSlabParameters, tally_count), FIELD(TynSlabParameters, radial_bins), FIELD(TynSlabParameters, angular_bins),
      FIELD(TynSlabParameters, depth_bins), FIELD(TynSlabParameters, order_bins), FIELD(TynSlabParameters, path_bins),
      FIELD(TynSlabParameters, sweep_count), FIELD(TynSlabParameters, radial_scale),
      FIELD(TynSlabParameters, depth_scale), FIELD(TynSlabParameters, path_scale), FIELD(TynSlabParameters, radial),
      FIELD(TynSlabParameters, angular), FIELD(TynSlabParameters, radial_angular), FIELD(TynSlabParameters, depth),
      FIELD(TynSlabParameters, order), FIELD(TynSlabParameters, path), FIELD(TynSlabParameters, sweep),
      FIELD(TynSlabParameters, escapes), FIELD(TynSlabParameters, escape_first_radius),
      FIELD(TynSlabParameters, escape_radii),
      // clang-format on
  };
  return layout;
}

std::string without_comments(std::string text) {
  text = std::regex_replace(text, std::regex("//[^\n]*"), "");
  std::string clean;
  for (size_t begin = 0; begin < text.size();) {
    size_t comment = text.find("/*", begin);
    clean += text.substr(begin, comment - begin);
    size_t end = comment == std::string::npos ? comment : text.find("*/", comment);
    begin = end == std::string::npos ? text.size() : end + 2;
  }
  return clean;
}

// The fields of a record's body: "float a[3]; uint32_t b, c;" gives a, b, c.
std::vector<std::string> fields_of(const std::string &body) {
  std::vector<std::string> fields;
  static const std::regex field("(\\w+)\\s*(\\[\\w+\\]\\s*)*[,;]");
  for (std::sregex_iterator i(body.begin(), body.end(), field), end; i != end; ++i)
    fields.push_back((*i)[1]);
  return fields;
}

struct Record {
  std::string name;
  std::vector<std::string> fields;
};

// The records that a program's source declares: "typedef struct TynName { ... } TynName;".
std::vector<Record> records_of(const std::string &text) {
  std::vector<Record> records;
  static const std::regex record("typedef struct (Tyn\\w+) \\{([^}]*)\\}");
  std::string clean = without_comments(text);
  for (std::sregex_iterator i(clean.begin(), clean.end(), record), end; i != end; ++i)
    records.push_back({(*i)[1], fields_of((*i)[2])});
  return records;
}

// A kernel that writes down sizes and offsets, in the order of `names`.
std::string reporter(const std::vector<Record> &records, std::vector<std::string> &names) {
  std::string body;
  auto report = [&](const std::string &name, const std::string &value) {
    body += "  layout[" + std::to_string(names.size()) + "] = (uint)(" + value + ");\n";
    names.push_back(name);
  };
  for (const Record &record : records) {
    report(record.name, "sizeof(" + record.name + ")");
    body += "  {\n  " + record.name + " r;\n";
    for (const std::string &field : record.fields)
      report(record.name + "." + field, "(char *)&r." + field + " - (char *)&r");
    body += "  }\n";
  }
  return "\nkernel void report_layout(global uint *layout) {\n" + body + "}\n";
}

// What the device makes of the records in one embedded program.
Layout device_layout(TynContext &context, const tyn::KernelSource &source) {
  std::vector<std::string> names;
  std::string text = source.text + reporter(records_of(source.text), names);
  std::string name = std::string("layout_of_") + source.name;
  Layout layout;
  if (names.empty())
    return layout;
  context.build(tyn::KernelSource{name.c_str(), text.c_str(), text.size(), std::hash<std::string>()(text)});
  tyn::Buffer buffer(context, names.size() * sizeof(uint32_t));
  context.launch(name.c_str(), "report_layout", 1, 1, buffer);
  std::vector<uint32_t> values(names.size());
  context.read(buffer, values.data(), buffer.size());
  for (size_t i = 0; i < names.size(); ++i)
    layout[names[i]] = values[i];
  return layout;
}

TEST(SharedStructs, HaveTheSameLayoutOnHostAndDevice) {
  Layout seen;
  tyn_test::ContextHandle context = tyn_test::make_context(1, 0, ""); // without a cache nothing else is compiled
  for (size_t i = 0; i < tyn::kernel_source_count; ++i)
    for (const auto &[name, value] : device_layout(*context, tyn::kernel_sources[i])) {
      auto host = host_layout().find(name);
      ASSERT_NE(host, host_layout().end())
          << name << " of " << tyn::kernel_sources[i].name << " is missing in this test";
      EXPECT_EQ(host->second, value) << name << " in " << tyn::kernel_sources[i].name;
      seen[name] = value;
    }
  for (const auto &[name, value] : host_layout())
    EXPECT_EQ(seen.count(name), 1u) << "no program has " << name << ", " << value;
}

TEST(SharedStructs, HaveTheSizesThatTheirCommentsState) {
  EXPECT_EQ(sizeof(TynWalkEntry), 96u);
  EXPECT_EQ(sizeof(TynWalkExit), 96u);
  EXPECT_EQ(sizeof(TynBssrdfPath), 72u);
  EXPECT_EQ(sizeof(TynProfileRecord), 72u);
  EXPECT_EQ(sizeof(TynBvhNode), 224u);
  EXPECT_EQ(sizeof(TynTriangleBlock), 160u);
  EXPECT_EQ(sizeof(TynTriangleRecord), 24u);
  EXPECT_EQ(sizeof(TynMeshRecord), 104u);
  EXPECT_EQ(sizeof(TynPhaseRecord), 32u);
  EXPECT_EQ(sizeof(TynMediumRecord), 48u);
  EXPECT_EQ(sizeof(TynWalkParameters), 44u);
  EXPECT_EQ(sizeof(TynWalkTally), 40u);
  EXPECT_EQ(sizeof(TynBssrdfEntry), 48u);
  EXPECT_EQ(sizeof(TynBssrdfExit), 80u);
}

} // namespace
