// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
#include "io/failure.hpp"

#include <cstdarg>
#include <cstdio>

namespace tyn::io {
namespace {

std::string format_list(const char *format, va_list arguments) {
  va_list copy;
  va_copy(copy, arguments);
  const int length = std::vsnprintf(nullptr, 0, format, copy);
  va_end(copy);
  std::string result(length > 0 ? size_t(length) : 0, '\0');
  if (length > 0)
    std::vsnprintf(&result[0], result.size() + 1, format, arguments);
  return result;
}

} // namespace

void fail(TynStatus status, const char *format, ...) {
  va_list arguments;
  va_start(arguments, format);
  const std::string message = format_list(format, arguments);
  va_end(arguments);
  throw Failure(status, message);
}

std::string text(const char *format, ...) {
  va_list arguments;
  va_start(arguments, format);
  std::string result = format_list(format, arguments);
  va_end(arguments);
  return result;
}

std::string printable(const std::string &raw) {
  constexpr size_t LONGEST = 200;
  std::string result;
  for (const char c : raw) {
    if (result.size() == LONGEST)
      return result + "...";
    const unsigned char byte = static_cast<unsigned char>(c);
    result += byte < 0x20 || byte == 0x7f ? '?' : c;
  }
  return result;
}

void require_ok(TynContext *context, TynStatus status) {
  if (status != TYN_OK)
    throw Failure(status, tyn_context_message(context));
}

void Warnings::add(const char *format, ...) {
  va_list arguments;
  va_start(arguments, format);
  const std::string line = format_list(format, arguments);
  va_end(arguments);
  if (seen.insert(line).second && function)
    function(user, line.c_str());
}

} // namespace tyn::io
