// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace tyn {

constexpr double pi = 3.14159265358979323846;

} // namespace tyn
