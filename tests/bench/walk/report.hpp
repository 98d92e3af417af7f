// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
// What bench-walk prints: a table as the results come, or one JSON document of them all.
#pragma once

#include <vector>

#include "bench/walk/measure.hpp"

namespace bench {

struct Results {
  TynDeviceInfo device{};
  std::vector<Build> builds;
  std::vector<Result> cases;
  std::vector<OneWalk> one_walks;
  std::vector<Overrides> overrides;
};

void print_header(const TynDeviceInfo &device);
void print(const Build &build);
void print_columns();
void print(const Result &result);
void print(const OneWalk &one);
void print(const Overrides &overrides);
void print_summary(const Results &results);
void print_json(const Results &results);
// To standard error, if the two walks do not lead to the same escaped weight.
void warn(const Result &result);

} // namespace bench
