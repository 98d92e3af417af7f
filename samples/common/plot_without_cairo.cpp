// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
//
// Stands in for plot.cpp where Cairo is not installed.
#include "common/plot.hpp"
#include "common/tool.hpp"

namespace tool {

bool plot_available() { return false; }

std::string draw_png(const Figure &) { throw Error(kFailed, "built without Cairo: plots cannot be drawn"); }

} // namespace tool
