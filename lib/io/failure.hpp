// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
// Errors and warnings of tyndall-io. Inside the library an error is a tyn::Failure; guarded() turns it into a status and the
// context's message at the C boundary. (tyndall hides its own helpers, hence these.)
#pragma once

#include <cstddef>
#include <cstring>
#include <new>
#include <set>
#include <string>

#include "core/status.hpp"
#include "tyndall/tyndall_io.h"

namespace tyn::io {

// Throws a Failure with a printf-formatted message.
[[noreturn]] void fail(TynStatus status, const char *format, ...) __attribute__((format(printf, 2, 3)));

// printf into a string.
std::string text(const char *format, ...) __attribute__((format(printf, 1, 2)));

// What comes from a file, fit for a message of one line: no control characters, not too long.
std::string printable(const std::string &raw);

// Throws what a call of the public API answered, with the context's message.
void require_ok(TynContext *context, TynStatus status);

// The caller's warning callback. The same line is given once.
class Warnings {
public:
  Warnings(TynWarning callback, void *data) : function(callback), user(data) {}
  void add(const char *format, ...) __attribute__((format(printf, 2, 3)));

private:
  TynWarning function;
  void *user;
  std::set<std::string> seen;
};

// A copy of a caller's option struct; NULL means the defaults. A shorter struct comes from a program that was compiled for an
// earlier library: what it lacks keeps its default.
template <class Options>
Options copy_options(const char *type, const Options *given, Options defaults) {
  if (!given)
    return defaults;
  if (given->size < 2 * sizeof(size_t) || given->size > sizeof(Options))
    fail(TYN_ERROR_INVALID_ARGUMENT, "%s::size is %zu; it must be sizeof(%s) = %zu", type, given->size, type,
         sizeof(Options));
  std::memcpy(&defaults, given, given->size);
  return defaults;
}

// Runs `body` and answers with its status; the message goes to the context (NULL: INVALID_ARGUMENT).
template <class Body>
TynStatus guarded(TynContext *context, Body &&body) {
  if (!context)
    return TYN_ERROR_INVALID_ARGUMENT;
  try {
    body();
    return TYN_OK;
  } catch (const Failure &failure) {
    return tyn_context_fail(context, failure.status, failure.what());
  } catch (const std::bad_alloc &) {
    return tyn_context_fail(context, TYN_ERROR_OUT_OF_MEMORY, "out of host memory");
  } catch (const std::exception &error) {
    return tyn_context_fail(context, TYN_ERROR_INTERNAL, error.what());
  }
}

} // namespace tyn::io
