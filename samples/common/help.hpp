// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
//
// --help: what the tool does and examples first, then every option, in one layout for all tools.
#pragma once

#include "common/tool.hpp"

#include <CLI/CLI.hpp>

#include <cstdio>
#include <memory>
#include <string>

namespace tool {

class HelpFormatter : public CLI::Formatter {
public:
  HelpFormatter() { column_width(32); }

  std::string make_help(const CLI::App *app, std::string, CLI::AppFormatMode mode) const override {
    return app->get_description() + make_groups(app, mode);
  }

  // The name of what an option takes, without what CLI11 adds behind a colon about checks: ranges are in the
  // descriptions. A name's own colon is written twice.
  std::string make_option_opts(const CLI::Option *option) const override {
    const std::string type = option->get_type_name();
    std::string name = type.empty() ? "" : " ";
    for (size_t i = 0; i < type.size(); ++i) {
      if (type[i] == ':' && type.compare(i++, 2, "::") != 0)
        break;
      name += type[i];
    }
    return name;
  }
};

// Parses the command line; false if it asked for --help or --version, which has been printed. Wrong usage throws.
inline bool parse_or_answer(CLI::App &app, const char *tool_name, int argc, char **argv) {
  app.formatter(std::make_shared<HelpFormatter>());
  app.set_help_flag("-h,--help", "print this");
  app.set_version_flag("--version", version_line(tool_name), "print the version");
  try {
    app.parse(argc, argv);
    // an unset variable in a script: not the same as an option that was not given
    for (const CLI::Option *option : app.get_options())
      for (const std::string &word : option->results())
        if (word.empty())
          throw CLI::ValidationError(option->get_name(), "the value is empty");
  } catch (const CLI::CallForHelp &) {
    std::fputs(app.help().c_str(), stdout);
    return false;
  } catch (const CLI::CallForVersion &version) {
    std::printf("%s\n", version.what());
    return false;
  }
  return true;
}

} // namespace tool
