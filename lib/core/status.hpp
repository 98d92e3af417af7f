// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
// Errors inside the library are exceptions; the C boundary turns them into a status and a message.
#pragma once

#include <cstdarg>
#include <new>
#include <stdexcept>
#include <string>

#include "tyndall/tyndall.h"

namespace tyn {

class Failure : public std::runtime_error {
public:
  Failure(TynStatus code, const std::string &message) : std::runtime_error(message), status(code) {}
  TynStatus status;
};

// Throws a Failure with a printf-formatted message.
[[noreturn]] void fail(TynStatus status, const char *format, ...) __attribute__((format(printf, 2, 3)));

// printf into a string.
std::string format(const char *format, ...) __attribute__((format(printf, 1, 2)));

} // namespace tyn
