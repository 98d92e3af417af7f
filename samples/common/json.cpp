// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
#include "common/json.hpp"

#include <cstdio>

namespace tool {

Json to_json(const TynDeviceInfo &device) {
  return {{"name", device.name},
          {"platform", device.platform},
          {"driver", device.driver},
          {"gpu", device.is_gpu != 0},
          {"compute_units", device.compute_units},
          {"memory", device.memory},
          {"lane_width", device.lane_width}};
}

Json to_json(const TynLedger &ledger) {
  return {{"entered", triple(ledger.entered)},
          {"reflected", triple(ledger.reflected)},
          {"escaped", triple(ledger.escaped)},
          {"absorbed", triple(ledger.absorbed)},
          {"balance", triple(ledger.balance)},
          {"capped", triple(ledger.capped)},
          {"leaked", triple(ledger.leaked)},
          {"lost", triple(ledger.lost)},
          {"walks", ledger.walks},
          {"escaped_walks", ledger.escaped_walks},
          {"absorbed_walks", ledger.absorbed_walks},
          {"capped_walks", ledger.capped_walks},
          {"leaked_walks", ledger.leaked_walks},
          {"lost_walks", ledger.lost_walks},
          {"reflected_walks", ledger.reflected_walks},
          {"scatterings", ledger.scatterings}};
}

Json to_json(const TynSceneInfo &scene) {
  return {{"meshes", scene.mesh_count},
          {"triangles", scene.triangle_count},
          {"media", scene.medium_count},
          {"materials", scene.material_count},
          {"images", scene.image_count},
          {"lights", scene.light_count},
          {"cameras", scene.camera_count},
          {"emissive_triangles", scene.emissive_triangle_count},
          {"environment", scene.has_environment != 0},
          {"metres_per_unit", scene.metres_per_unit},
          {"lower", triple(scene.lower)},
          {"upper", triple(scene.upper)}};
}

void print_json(const Json &object) {
  const std::string text = object.dump(2, ' ', false, Json::error_handler_t::replace);
  std::printf("%s\n", text.c_str());
}

} // namespace tool
