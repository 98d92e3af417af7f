// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
#include "common/plot_scale.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace tool {
namespace {

constexpr double kSteps = 5.0;      // about so many between the ticks of a linear axis
constexpr double kFewDecades = 2.5; // up to so many of a log axis are labelled at 2 and 5 too
constexpr double kRounding = 1e-9;  // of a range: what is beyond its end by less is on it

// 1, 2 or 5 times a power of ten, about `raw`.
double round_step(double raw) {
  const double decade = std::pow(10.0, std::floor(std::log10(raw)));
  const double mantissa = raw / decade;
  return decade * (mantissa < 1.5 ? 1.0 : mantissa < 3.5 ? 2.0 : mantissa < 7.5 ? 5.0 : 10.0);
}

std::string with_minus(std::string text) {
  const size_t at = text.find('-');
  return at == std::string::npos ? text : text.replace(at, 1, "\xe2\x88\x92"); // U+2212, as wide as a plus
}

std::string fixed(double value, int decimals) {
  char text[64];
  std::snprintf(text, sizeof text, "%.*f", decimals, value);
  return with_minus(text);
}

std::string power_of_ten(int exponent) { return "10^{" + with_minus(std::to_string(exponent)) + "}"; }

// Labels of log axes that span little: 0.2, 50, 2·10^{-5}.
std::string log_label(int digit, int exponent) {
  if (exponent >= -3 && exponent <= 3)
    return fixed(digit * std::pow(10.0, exponent), std::max(0, -exponent));
  return digit == 1 ? power_of_ten(exponent) : std::to_string(digit) + "\xc2\xb7" + power_of_ten(exponent);
}

// The nearest of 1, 2 and 5 times a power of ten that is not below `value`, or not above it.
double round_outwards(double value, bool up) {
  const double decade = std::pow(10.0, std::floor(std::log10(value) + kRounding));
  double below = decade;
  for (const double digit : {1.0, 2.0, 5.0, 10.0}) {
    if (up && digit * decade >= value * (1.0 - kRounding))
      return digit * decade;
    if (digit * decade <= value * (1.0 + kRounding))
      below = digit * decade;
  }
  return below;
}

} // namespace

Scale::Scale(const PlotAxis &axis, double lowest, double highest, bool fit)
    : log_(axis.log), low_(lowest), high_(highest) {
  if (axis.range.size() == 2) {
    low_ = axis.range[0];
    high_ = axis.range[1];
    fit = false;
  }
  if (!axis.categories.empty())
    add_categories(axis.categories);
  else if (log_)
    set_log(fit);
  else
    set_linear(axis, fit);
}

double Scale::position(double value) const {
  if (!log_)
    return (value - low_) / (high_ - low_);
  if (!(value > 0.0))
    return -1e3;
  return std::log(value / low_) / std::log(high_ / low_);
}

void Scale::add_categories(const std::vector<std::string> &names) {
  low_ = -0.5;
  high_ = static_cast<double>(names.size()) - 0.5;
  for (size_t i = 0; i < names.size(); ++i)
    ticks_.push_back({static_cast<double>(i), names[i]});
}

void Scale::set_linear(const PlotAxis &axis, bool fit) {
  if (!(high_ > low_))
    high_ = low_ + (low_ == 0.0 ? 1.0 : std::fabs(low_));
  const double step = axis.step > 0.0 ? axis.step : round_step((high_ - low_) / kSteps);
  const double slack = kRounding * (high_ - low_);
  if (fit) {
    low_ = step * std::floor((low_ + slack) / step);
    high_ = step * std::ceil((high_ - slack) / step);
  }
  // Numbers that are all tiny or huge share a factor, which stands at the axis.
  const double largest = std::max(std::fabs(low_), std::fabs(high_));
  int exponent = static_cast<int>(std::floor(std::log10(largest) + kRounding));
  if (exponent >= -2 && exponent <= 4)
    exponent = 0;
  if (exponent)
    factor_ = power_of_ten(exponent);
  const double unit = std::pow(10.0, exponent);
  const int decimals = std::max(0, -static_cast<int>(std::floor(std::log10(step / unit) + kRounding)));
  for (double i = std::ceil((low_ - slack) / step); i * step <= high_ + slack; ++i)
    ticks_.push_back({i * step, fixed(i * step / unit + 0.0, decimals)});
}

void Scale::set_log(bool fit) {
  if (!(low_ > 0.0) || !(high_ > low_)) {
    high_ = high_ > 0.0 ? high_ : 1.0;
    low_ = 0.1 * high_;
  }
  if (fit) {
    low_ = round_outwards(low_, false);
    high_ = round_outwards(high_, true);
  }
  const int first = static_cast<int>(std::floor(std::log10(low_) + kRounding));
  const int last = static_cast<int>(std::floor(std::log10(high_) + kRounding));
  const int every = 1 + (last - first) / 8;
  for (int decade = first; decade <= last; ++decade)
    add_decade(decade, std::log10(high_ / low_) < kFewDecades, every);
}

void Scale::add_decade(int decade, bool labels_between, int every) {
  for (int digit = 1; digit <= 9; ++digit) {
    const double value = digit * std::pow(10.0, decade);
    if (value < low_ * (1.0 - kRounding) || value > high_ * (1.0 + kRounding))
      continue;
    std::string label;
    if (digit == 1 && decade % every == 0)
      label = labels_between ? log_label(1, decade) : power_of_ten(decade);
    else if (labels_between && (digit == 2 || digit == 5))
      label = log_label(digit, decade);
    if (digit == 1 || every == 1)
      ticks_.push_back({value, label});
  }
}

} // namespace tool
