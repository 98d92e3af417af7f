// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
//
// Progress on standard error: a bar on a terminal, one line for every 10 % anywhere else.
#pragma once

#include <chrono>
#include <string>

namespace tool {

struct ProgressState {
  double fraction = 0.0;    // done, 0 .. 1
  const char *what = "";    // that is being made, where it is not the result
  unsigned samples = 0;     // a pixel, so far; 0, without a goal: not what this tool counts
  unsigned sample_goal = 0; // 0: no goal
  double error = 0.0;       // relative standard error; 0: not known yet
};

class Progress {
public:
  Progress(const char *tool_name, bool quiet);

  // Cheap enough to be called often: draws at most ten times a second.
  void update(const ProgressState &state);

  // Wipes the bar, so that what is printed next starts on a clean line.
  void finish();

private:
  void draw_bar(const ProgressState &state);
  void print_line(const ProgressState &state);
  std::string details(const ProgressState &state) const;

  using Clock = std::chrono::steady_clock;
  const char *tool_name_;
  bool quiet_;
  bool terminal_;
  bool drawn_ = false;
  int last_tenth_ = 0;
  Clock::time_point start_ = Clock::now();
  Clock::time_point last_draw_;
};

} // namespace tool
