// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
//
// The library's records as JSON, for --json. Numbers that are not finite become null.
#pragma once

#include <tyndall/tyndall.h>

#include <nlohmann/json.hpp>

#include <string>

namespace tool {

using Json = nlohmann::ordered_json; // keys in the order in which they are written here

template <typename Number>
Json triple(const Number (&values)[3]) {
  return Json::array({values[0], values[1], values[2]});
}

Json to_json(const TynDeviceInfo &device);
Json to_json(const TynLedger &ledger);
Json to_json(const TynSceneInfo &scene);

// Prints `object` and nothing else on standard output. Names that are not UTF-8 are repaired, not refused.
void print_json(const Json &object);

} // namespace tool
