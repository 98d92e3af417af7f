// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
//
// Everything that there is to say, for all kinds of output.
#pragma once

#include "profile/arguments.hpp"
#include "profile/radii.hpp"

namespace profile {

// Over radii or rings, of one channel; NaN where there is nothing to say.
struct Curve {
  std::vector<double> values, errors; // errors: standard ones; empty: none
};

struct ModelResults {
  std::string name;
  std::vector<std::vector<double>> profile; // [channel][radius]
  std::vector<std::vector<double>> errors;  // [channel][radius], standard ones of `profile`; empty: none
  std::vector<double> albedo;               // [channel]
  // with --error:
  std::vector<Curve> ring_means;             // [channel]
  std::vector<Curve> deviation;              // [channel], model / exact - 1
  std::vector<TynEstimate> albedo_deviation; // [channel]
};

struct ExactResults {
  std::vector<double> edges;       // of the rings: one more than there are radii
  std::vector<Curve> profile;      // [channel], means over rings
  std::vector<TynEstimate> albedo; // [channel]
  TynSlabRun run = {};
};

struct Results {
  bool interrupted = false;
  TynDeviceInfo device = {};
  std::vector<std::string> channel_names;
  std::vector<ModelResults> models;
  std::vector<std::string> missing; // models that Ctrl-C left no table for
  ExactResults exact;               // with --error
};

} // namespace profile
