// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
#include "slab/parse.hpp"

#include "common/tool.hpp"

#include <charconv>
#include <cmath>

namespace slab {
namespace {

constexpr double kPi = 3.14159265358979323846;
constexpr uint64_t kMostBins = 1000000;
constexpr uint64_t kMostAlbedos = 4096;
constexpr double kMostExactInteger = 9007199254740992.0; // 2^53: beyond it a double skips whole numbers

// The rest of `text` behind "word:"; false if it begins otherwise.
bool behind(const std::string &text, const std::string &word, std::string &rest) {
  if (text.compare(0, word.size() + 1, word + ":") != 0)
    return false;
  rest = text.substr(word.size() + 1);
  return true;
}

} // namespace

void wrong(const std::string &option, const std::string &text, const std::string &expected) {
  throw tool::Error(tool::kUsage, option + " " + (text.empty() ? "''" : text) + ": expected " + expected);
}

std::vector<std::string> split(const std::string &text, char separator) {
  std::vector<std::string> parts;
  size_t begin = 0;
  for (size_t end; (end = text.find(separator, begin)) != std::string::npos; begin = end + 1)
    parts.push_back(text.substr(begin, end - begin));
  parts.push_back(text.substr(begin));
  return parts;
}

bool parse_number(const std::string &text, double &value) {
  const char *end = text.data() + text.size();
  const std::from_chars_result result = std::from_chars(text.data(), end, value);
  return result.ec == std::errc() && result.ptr == end && !std::isnan(value);
}

double number_between(const std::string &option, const std::string &text, double lowest, double highest,
                      const std::string &expected) {
  double value = 0.0;
  if (!parse_number(text, value) || value < lowest || value > highest)
    wrong(option, text, expected);
  return value;
}

uint64_t whole_number(const std::string &option, const std::string &text, uint64_t lowest, uint64_t highest,
                      const std::string &expected) {
  double value = 0.0;
  if (!parse_number(text, value) || value != std::floor(value) || value < static_cast<double>(lowest) ||
      value > static_cast<double>(highest) || value > kMostExactInteger)
    wrong(option, text, expected);
  return static_cast<uint64_t>(value);
}

uint64_t parse_seed(const std::string &text) {
  uint64_t seed = 0;
  const char *end = text.data() + text.size();
  const std::from_chars_result result = std::from_chars(text.data(), end, seed);
  if (result.ec != std::errc() || result.ptr != end)
    wrong("--seed", text, "a whole number from 0 to 18446744073709551615");
  return seed;
}

Axis parse_axis(const std::string &option, const std::string &text) {
  const std::string expected = "END:BINS with a length above 0 and 1 to 1000000 bins, such as 5:100";
  const std::vector<std::string> parts = split(text, ':');
  double bins = 0.0;
  Axis axis;
  if (parts.size() != 2 || !parse_number(parts[0], axis.end) || !parse_number(parts[1], bins))
    wrong(option, text, expected);
  if (!(axis.end > 0.0) || std::isinf(axis.end) || bins != std::floor(bins) || bins < 1.0 || bins > kMostBins)
    wrong(option, text, expected);
  axis.bins = static_cast<uint32_t>(bins);
  return axis;
}

void parse_incidence(const std::string &text, TynSlabOptions &options) {
  const std::string expected = "normal, angle:DEGREES with 0 to less than 90, or diffuse";
  std::string rest;
  double degrees = 0.0;
  if (text == "normal")
    return;
  if (text == "diffuse") {
    options.incidence = TYN_INCIDENCE_DIFFUSE;
    return;
  }
  if (!behind(text, "angle", rest) || !parse_number(rest, degrees) || !(degrees >= 0.0 && degrees < 90.0))
    wrong("--incidence", text, expected);
  options.angle = degrees * (kPi / 180.0);
}

void parse_beam(const std::string &text, TynSlabOptions &options) {
  const std::string expected = "pencil, disc:RADIUS or gaussian:RADIUS with a radius above 0";
  std::string rest;
  if (text == "pencil")
    return;
  const bool disc = behind(text, "disc", rest);
  if (!disc && !behind(text, "gaussian", rest))
    wrong("--beam", text, expected);
  double radius = 0.0;
  if (!parse_number(rest, radius) || !(radius > 0.0) || std::isinf(radius))
    wrong("--beam", text, expected);
  options.beam = disc ? TYN_BEAM_DISC : TYN_BEAM_GAUSSIAN;
  options.beam_radius = radius;
}

std::vector<double> parse_albedos(const std::string &text) {
  const std::string expected = "albedos from 0 to 1, W,W,... or MIN:MAX:N with 2 to 4096 of them";
  std::vector<double> albedos;
  const std::vector<std::string> range = split(text, ':');
  if (range.size() == 1) {
    for (const std::string &part : split(text, ','))
      albedos.push_back(number_between("--sweep-albedo", part, 0.0, 1.0, expected));
    if (albedos.size() > kMostAlbedos)
      wrong("--sweep-albedo", std::to_string(albedos.size()) + " values", expected);
    return albedos;
  }
  double ends[2] = {}, count = 0.0;
  if (range.size() != 3 || !parse_number(range[0], ends[0]) || !parse_number(range[1], ends[1]) ||
      !parse_number(range[2], count) || !(ends[0] >= 0.0 && ends[0] <= ends[1] && ends[1] <= 1.0) ||
      count != std::floor(count) || count < 2.0 || count > kMostAlbedos)
    wrong("--sweep-albedo", text, expected);
  const auto steps = static_cast<size_t>(count) - 1;
  for (size_t i = 0; i <= steps; ++i)
    albedos.push_back(i == steps ? ends[1] : ends[0] + (ends[1] - ends[0]) * static_cast<double>(i) / steps);
  return albedos;
}

} // namespace slab
