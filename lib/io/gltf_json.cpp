// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
#include "io/gltf_json.hpp"

#include "io/failure.hpp"

namespace tyn::io {
namespace {

// Deeper nesting is no model; it would only serve to exhaust the stack of whoever walks it.
constexpr int DEEPEST_JSON = 64;

// nlohmann's messages begin with "[json.exception.parse_error.101] ".
std::string without_prefix(const char *message) {
  const std::string whole = message;
  const size_t end = whole.find("] ");
  return printable(end == std::string::npos ? whole : whole.substr(end + 2));
}

// Counts brackets outside of strings. (nlohmann's parser can report depths, but takes quadratic time then.)
void refuse_depth(Span text) {
  int depth = 0;
  bool quoted = false;
  for (size_t i = 0; i < text.size; i++) {
    const uint8_t c = text.data[i];
    if (quoted && c == '\\')
      i++;
    else if (c == '"')
      quoted = !quoted;
    else if (!quoted)
      depth += (c == '[' || c == '{') - (c == ']' || c == '}');
    if (depth > DEEPEST_JSON)
      fail(TYN_ERROR_FORMAT, "the JSON is nested more than %d levels deep", DEEPEST_JSON);
  }
}

} // namespace

Json parse_json(Span text) {
  refuse_depth(text);
  try {
    Json root = Json::parse(text.data, text.data + text.size);
    if (!root.is_object())
      fail(TYN_ERROR_FORMAT, "the JSON is not an object");
    return root;
  } catch (const Json::exception &error) {
    fail(TYN_ERROR_FORMAT, "not a glTF file: %s", without_prefix(error.what()).c_str());
  }
}

} // namespace tyn::io
