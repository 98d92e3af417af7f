// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
//
// Ctrl-C: the first asks politely, the second kills.
#pragma once

namespace tool {

// From here on the first SIGINT only sets a flag; the next one ends the process as usual.
void catch_interrupt();

bool interrupted();

} // namespace tool
