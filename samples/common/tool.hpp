// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
//
// What every command-line tool has in common: exit statuses, errors that end it, owners of library handles.
#pragma once

#include <tyndall/tyndall.h>

#include <memory>
#include <stdexcept>
#include <string>

namespace tool {

enum ExitCode {
  kOk = 0,
  kFailed = 1,
  kUsage = 2,
  kBadInput = 3,
  kNoDevice = 4,
  kInterrupted = 130,
};

// Ends the tool with one line on standard error and an exit status.
class Error : public std::runtime_error {
public:
  Error(ExitCode code, const std::string &message) : std::runtime_error(message), code_(code) {}
  ExitCode code() const { return code_; }

private:
  ExitCode code_;
};

// Runs a tool's body and turns whatever it throws into `NAME: message` and an exit status. No library call and no
// wrong argument ends in an abort.
int run(const char *name, int argc, char **argv, int (*body)(int, char **));

// Throws the context's message unless `status` is TYN_OK. A missing device and a failed kernel build have their own
// exit status, whatever the caller was doing; `code` is for everything else.
void check(TynStatus status, const TynContext *context, ExitCode code = kFailed);

// `text` fit for a terminal: names come from files, and control characters in them must not reach it.
std::string printable(const std::string &text);

template <typename Handle, void (*release)(Handle *)>
struct Releaser {
  void operator()(Handle *handle) const { release(handle); }
};
using Context = std::unique_ptr<TynContext, Releaser<TynContext, tyn_context_release>>;
using Scene = std::unique_ptr<TynScene, Releaser<TynScene, tyn_scene_release>>;
using Renderer = std::unique_ptr<TynRenderer, Releaser<TynRenderer, tyn_renderer_release>>;

// Creates a context on `device` (an index or part of a name; empty: the library's choice).
Context create_context(const std::string &device);

// Text of --version.
std::string version_line(const char *name);

} // namespace tool
