// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
#include "io/base64.hpp"

#include "io/failure.hpp"

namespace tyn::io {
namespace {

// The six bits of a base64 digit, or -1. Both alphabets of RFC 4648 are understood.
int digit(char c) {
  if (c >= 'A' && c <= 'Z')
    return c - 'A';
  if (c >= 'a' && c <= 'z')
    return c - 'a' + 26;
  if (c >= '0' && c <= '9')
    return c - '0' + 52;
  if (c == '+' || c == '-')
    return 62;
  return c == '/' || c == '_' ? 63 : -1;
}

} // namespace

bool is_data_uri(const std::string &uri) { return uri.compare(0, 5, "data:") == 0; }

Bytes decode_data_uri(const std::string &uri) {
  const size_t comma = uri.find(',');
  if (comma == std::string::npos || comma < 7 || uri.compare(comma - 7, 7, ";base64") != 0)
    fail(TYN_ERROR_FORMAT, "the data URI is not base64");
  size_t end = uri.size();
  while (end > comma + 1 && uri[end - 1] == '=')
    end--;
  Bytes result;
  result.reserve((end - comma) * 3 / 4);
  uint32_t bits = 0;
  int count = 0;
  for (size_t i = comma + 1; i < end; i++) {
    const int value = digit(uri[i]);
    if (value < 0)
      fail(TYN_ERROR_FORMAT, "the data URI has a character that is not base64 at position %zu", i - comma - 1);
    bits = bits << 6 | uint32_t(value);
    count += 6;
    if (count >= 8) {
      count -= 8;
      result.push_back(uint8_t(bits >> count));
    }
  }
  return result;
}

} // namespace tyn::io
