// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
#include "core/status.hpp"

#include <cstdio>

namespace tyn {
namespace {

std::string format_list(const char *format, va_list arguments) {
  va_list again;
  va_copy(again, arguments);
  const int length = std::vsnprintf(nullptr, 0, format, again);
  va_end(again);
  if (length <= 0)
    return {};
  std::string text(static_cast<size_t>(length), '\0');
  std::vsnprintf(&text[0], text.size() + 1, format, arguments);
  return text;
}

} // namespace

std::string format(const char *format, ...) {
  va_list arguments;
  va_start(arguments, format);
  std::string text = format_list(format, arguments);
  va_end(arguments);
  return text;
}

void fail(TynStatus status, const char *format, ...) {
  va_list arguments;
  va_start(arguments, format);
  const std::string text = format_list(format, arguments);
  va_end(arguments);
  throw Failure(status, text);
}

} // namespace tyn

uint32_t tyn_version(void) { return TYN_VERSION; }

const char *tyn_status_string(TynStatus status) {
  switch (status) {
  case TYN_OK:
    return "ok";
  case TYN_ERROR_INVALID_ARGUMENT:
    return "invalid argument";
  case TYN_ERROR_INVALID_OPERATION:
    return "invalid operation";
  case TYN_ERROR_OUT_OF_MEMORY:
    return "out of memory";
  case TYN_ERROR_NO_DEVICE:
    return "no device";
  case TYN_ERROR_KERNEL_BUILD:
    return "kernel build failed";
  case TYN_ERROR_DEVICE:
    return "device error";
  case TYN_ERROR_CANCELLED:
    return "cancelled";
  case TYN_ERROR_FILE:
    return "file error";
  case TYN_ERROR_FORMAT:
    return "format error";
  case TYN_ERROR_INTERNAL:
    return "internal error";
  default:
    return "unknown status";
  }
}
