// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
#include "common/tool.hpp"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cstdio>
#include <new>

namespace tool {
namespace {

bool is_control(char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7f; }

// The first line says what is wrong; a kernel build log may follow it.
void report(const char *name, const std::string &message) {
  const size_t end = message.find('\n');
  std::fprintf(stderr, "%s: %s\n", name, printable(message.substr(0, end)).c_str());
  if (end == std::string::npos || end + 1 == message.size())
    return;
  const bool ends_with_newline = message.back() == '\n';
  std::fprintf(stderr, "%s%s", message.c_str() + end + 1, ends_with_newline ? "" : "\n");
}

std::string one_line(std::string text) {
  std::replace(text.begin(), text.end(), '\n', ' ');
  while (!text.empty() && text.back() == ' ')
    text.pop_back();
  return text;
}

} // namespace

int run(const char *name, int argc, char **argv, int (*body)(int, char **)) {
  try {
    const int code = body(argc, argv);
    // what a full disk swallows only shows here
    if (std::fflush(stdout) != 0 || std::ferror(stdout))
      throw Error(kFailed, "standard output could not be written");
    return code;
  } catch (const Error &error) {
    report(name, error.what());
    return error.code();
  } catch (const CLI::ParseError &error) {
    report(name, one_line(error.what()) + " (see --help)");
    return kUsage;
  } catch (const std::bad_alloc &) {
    report(name, "out of memory");
    return kFailed;
  } catch (const std::exception &error) {
    report(name, one_line(error.what()));
    return kFailed;
  }
}

void check(TynStatus status, const TynContext *context, ExitCode code) {
  if (status == TYN_OK)
    return;
  if (status == TYN_ERROR_NO_DEVICE || status == TYN_ERROR_KERNEL_BUILD)
    code = kNoDevice;
  const char *message = tyn_context_message(context);
  throw Error(code, message && *message ? message : tyn_status_string(status));
}

std::string printable(const std::string &text) {
  std::string result = text;
  std::replace_if(result.begin(), result.end(), is_control, '?');
  return result;
}

Context create_context(const std::string &device) {
  char message[4096] = "";
  TynContextOptions options = tyn_context_options();
  options.device = device.empty() ? nullptr : device.c_str();
  options.message = message;
  options.message_capacity = sizeof message;
  TynContext *context = nullptr;
  const TynStatus status = tyn_context_create(&options, &context);
  if (status != TYN_OK)
    throw Error(kNoDevice, *message ? message : tyn_status_string(status));
  return Context(context);
}

std::string version_line(const char *name) {
  const uint32_t version = tyn_version();
  return std::string(name) + " " + std::to_string(version / 10000) + "." + std::to_string(version / 100 % 100) + "." +
         std::to_string(version % 100);
}

} // namespace tool
