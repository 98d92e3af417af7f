// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
// Tables on disk. A file that is missing, damaged, another's or that cannot be written costs time and nothing else.
#pragma once

#include <string>

#include "bssrdf/exact_table.hpp"

namespace tyn {

// All that a table depends on.
std::string exact_key(const TynPhase &phase, double ior, uint64_t events, uint64_t seed);

// False if there is none.
bool load_exact_table(const std::string &path, const std::string &key, const TynPhase &phase, ExactTable &table);
void store_exact_table(const std::string &path, const std::string &key, const ExactTable &table);

} // namespace tyn
