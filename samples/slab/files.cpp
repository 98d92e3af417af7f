// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
#include "slab/files.hpp"

#include "common/outputs.hpp"
#include "common/plot.hpp"

namespace slab {

using tool::Error;
using tool::kUsage;

void check_files(const char *tool_name, const Arguments &arguments) {
  if (tool::same_file(arguments.csv, arguments.plot))
    throw Error(kUsage, "--plot " + arguments.plot + ": expected another file than --csv " + arguments.csv);
  if (arguments.plot.empty())
    return;
  if (!tool::has_extension(arguments.plot, ".png"))
    throw Error(kUsage, "--plot " + arguments.plot + ": expected a name that ends in .png");
  if (!tool::plot_available())
    throw Error(kUsage, "--plot " + arguments.plot + ": this " + tool_name +
                            " was built without Cairo (libcairo2-dev) and cannot draw; --csv and --json can be plotted "
                            "elsewhere");
}

void check_writable(const Arguments &arguments) {
  for (const std::string *file : {&arguments.csv, &arguments.plot})
    if (!file->empty())
      tool::check_writable(*file, kUnwritable);
}

} // namespace slab
