// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
//
// Results in the forms that tyndall-profile has for them.
#pragma once

#include "common/json.hpp"
#include "common/plot.hpp"
#include "profile/results.hpp"

namespace profile {

// The object of --json.
tool::Json to_json(const char *tool_name, const Arguments &arguments, const Results &results);

// The table of --csv: one value a row.
std::string to_csv(const Arguments &arguments, const Results &results);

// The picture of --plot.
tool::Figure to_figure(const Arguments &arguments, const Results &results);

// What is said without --json, on standard output.
void print_text(const Arguments &arguments, const Results &results);

} // namespace profile
