// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
#include "common/progress.hpp"

#include <unistd.h>

#include <algorithm>
#include <cstdio>

namespace tool {
namespace {

constexpr int kBarWidth = 24; // with the text behind it, less than 80 columns

std::string format_duration(double seconds) {
  char text[32];
  const int whole = static_cast<int>(std::min(seconds + 0.5, 359999.0));
  if (whole < 60)
    std::snprintf(text, sizeof text, "%d s", whole);
  else if (whole < 3600)
    std::snprintf(text, sizeof text, "%d min %02d s", whole / 60, whole % 60);
  else
    std::snprintf(text, sizeof text, "%d h %02d min", whole / 3600, whole / 60 % 60);
  return text;
}

} // namespace

Progress::Progress(const char *tool_name, bool quiet)
    : tool_name_(tool_name), quiet_(quiet), terminal_(isatty(STDERR_FILENO) == 1),
      last_draw_(start_ - std::chrono::seconds(1)) {}

void Progress::update(const ProgressState &state) {
  if (quiet_)
    return;
  if (!terminal_) {
    print_line(state);
    return;
  }
  const Clock::time_point now = Clock::now();
  if (now - last_draw_ < std::chrono::milliseconds(100))
    return;
  last_draw_ = now;
  draw_bar(state);
}

void Progress::finish() {
  if (drawn_)
    std::fprintf(stderr, "\r\033[K");
  drawn_ = false;
}

// "table of exact, 12 s left", "29/64 samples, error 3.1 %, 12 s left"
std::string Progress::details(const ProgressState &state) const {
  char text[96] = "";
  std::string result;
  const auto append = [&](const std::string &part) { result += (result.empty() ? "" : ", ") + part; };
  if (*state.what)
    append(state.what);
  if (state.sample_goal)
    std::snprintf(text, sizeof text, "%u/%u samples", state.samples, state.sample_goal);
  else if (state.samples)
    std::snprintf(text, sizeof text, "%u samples", state.samples);
  if (*text)
    append(text);
  if (state.error > 0.0) {
    std::snprintf(text, sizeof text, "error %.2g %%", 100.0 * state.error);
    append(text);
  }
  const double elapsed = std::chrono::duration<double>(Clock::now() - start_).count();
  if (state.fraction > 0.01 && state.fraction < 1.0)
    append(format_duration(elapsed * (1.0 - state.fraction) / state.fraction) + " left");
  return result;
}

void Progress::draw_bar(const ProgressState &state) {
  const int filled = static_cast<int>(kBarWidth * std::clamp(state.fraction, 0.0, 1.0));
  const std::string bar = std::string(filled, '#') + std::string(kBarWidth - filled, '.');
  std::fprintf(stderr, "\r[%s] %3.0f %%  %s\033[K", bar.c_str(), 100.0 * state.fraction, details(state).c_str());
  drawn_ = true;
}

void Progress::print_line(const ProgressState &state) {
  const int tenth = static_cast<int>(10.0 * state.fraction + 1e-9);
  if (tenth <= last_tenth_)
    return;
  last_tenth_ = tenth;
  const std::string more = details(state);
  std::fprintf(stderr, "%s: %d %%%s%s\n", tool_name_, 10 * tenth, more.empty() ? "" : ", ", more.c_str());
}

} // namespace tool
