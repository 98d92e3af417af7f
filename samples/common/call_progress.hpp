// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
//
// The progress of one call of the library, which Ctrl-C cancels.
#pragma once

#include "common/interrupt.hpp"
#include "common/progress.hpp"

#include <cstdint>
#include <optional>

namespace tool {

class CallProgress {
public:
  // `what` is being made, where it is not the result.
  CallProgress(const char *tool_name, bool quiet, const char *what = "")
      : tool_name_(tool_name), quiet_(quiet), what_(what) {}
  ~CallProgress() {
    if (progress_)
      progress_->finish();
  }
  CallProgress(const CallProgress &) = delete;
  CallProgress &operator=(const CallProgress &) = delete;

  // A TynProgress whose `user` is a CallProgress.
  static int32_t report(void *user, double fraction) {
    CallProgress &self = *static_cast<CallProgress *>(user);
    ProgressState state;
    state.fraction = fraction;
    state.what = self.what_;
    // begun here, so that compiling kernels does not count as time for what the call does
    if (!self.progress_)
      self.progress_.emplace(self.tool_name_, self.quiet_);
    self.progress_->update(state);
    return interrupted();
  }

private:
  const char *tool_name_;
  bool quiet_;
  const char *what_;
  std::optional<Progress> progress_;
};

} // namespace tool
