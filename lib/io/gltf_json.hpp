// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
// The JSON of a glTF file: parsed, and checked before anything relies on it.
#pragma once

#include <nlohmann/json.hpp>

#include "io/gltf_container.hpp"

namespace tyn::io {

using Json = nlohmann::json;

// Parses the text. Throws FORMAT with line and column.
Json parse_json(Span text);

// Checks every property that the loader reads against the schema: its type, the length of arrays, whether required ones are
// there, and that every index exists. Throws FORMAT with the JSON path of the element and what is allowed. After that
// tinygltf, which silently skips properties of the wrong type, reads what the file says. Integers written as 3.0 become 3.
void check_schema(Json &root);

// Throws FORMAT unless the asset's version is 2.x, and for a required extension that is not supported. Returns the names of
// the optional extensions that will be ignored.
std::vector<std::string> check_extensions(const Json &root);

} // namespace tyn::io
