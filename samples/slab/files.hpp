// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
//
// The files that are written: --csv and --plot.
#pragma once

#include "common/tool.hpp"
#include "slab/arguments.hpp"

namespace slab {

constexpr tool::ExitCode kUnwritable = tool::kBadInput; // files have one status, whichever way they are used

// Throws wrong usage unless they are two files, and the plot one that this tool can draw.
void check_files(const char *tool_name, const Arguments &arguments);

// Throws if one of them cannot be written.
void check_writable(const Arguments &arguments);

} // namespace slab
