// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
#include "slab/messages.hpp"

#include <algorithm>

namespace slab {
namespace {

void replace_all(std::string &text, const std::string &what, const std::string &with) {
  for (size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + with.size()))
    text.replace(at, what.size(), with);
}

// "sigma_a" as the option that gives it
std::string option_of(std::string field) {
  std::replace(field.begin(), field.end(), '_', '-');
  return "--" + field;
}

} // namespace

std::string in_options(const std::string &message, const Arguments &arguments) {
  std::string text = message;
  for (size_t i = 0; i < arguments.layers.size(); ++i) {
    const std::string layer = "layers[" + std::to_string(i) + "].";
    if (arguments.is_stack)
      replace_all(text, layer, "--layer " + std::to_string(i + 1) + ": ");
    else
      for (const char *field : {"sigma_a", "sigma_s", "g", "ior", "thickness", "phase"})
        replace_all(text, layer + field, option_of(field));
  }
  replace_all(text, "INFINITY", "inf");
  return text;
}

} // namespace slab
