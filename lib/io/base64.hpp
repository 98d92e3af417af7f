// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
// Data URIs (RFC 2397), as glTF uses them: base64.
#pragma once

#include <string>

#include "io/input_file.hpp"

namespace tyn::io {

// Whether `uri` holds its data itself.
bool is_data_uri(const std::string &uri);

// The data of a data URI. Throws FORMAT.
Bytes decode_data_uri(const std::string &uri);

} // namespace tyn::io
