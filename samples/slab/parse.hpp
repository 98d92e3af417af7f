// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
//
// Values of tyndall-slab's options. What is not allowed throws one line: the option, the value, and what is.
#pragma once

#include <tyndall/tyndall_slab.h>

#include <cstdint>
#include <string>
#include <vector>

namespace slab {

// Throws wrong usage: "OPTION TEXT: expected EXPECTED".
[[noreturn]] void wrong(const std::string &option, const std::string &text, const std::string &expected);

std::vector<std::string> split(const std::string &text, char separator);

// The number that all of `text` is, with a point whatever the locale; false if it is none or NaN. May be infinite.
bool parse_number(const std::string &text, double &value);

// A number in [lowest, highest]; `expected` names the range.
double number_between(const std::string &option, const std::string &text, double lowest, double highest,
                      const std::string &expected);

// A whole number in [lowest, highest], which may be written as 1e7.
uint64_t whole_number(const std::string &option, const std::string &text, uint64_t lowest, uint64_t highest,
                      const std::string &expected);

// A seed: any whole number of 64 bits.
uint64_t parse_seed(const std::string &text);

// Equal steps from 0 to an end: END:BINS.
struct Axis {
  double end = 0.0;
  uint32_t bins = 0;
};
Axis parse_axis(const std::string &option, const std::string &text);

// normal, angle:DEGREES or diffuse.
void parse_incidence(const std::string &text, TynSlabOptions &options);

// pencil, disc:RADIUS or gaussian:RADIUS.
void parse_beam(const std::string &text, TynSlabOptions &options);

// W,W,... or MIN:MAX:N.
std::vector<double> parse_albedos(const std::string &text);

} // namespace slab
