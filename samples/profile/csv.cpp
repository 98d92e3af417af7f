// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
//
// Tidy data: every row is one value with all that says what it is. Beside a model's value at a radius stand the exact mean over
// the ring around it and the deviation of the model's own mean from that; empty where there is none. The albedo has no radius.
#include "profile/outputs.hpp"
#include "slab/format.hpp"

#include <cmath>

namespace profile {
namespace {

std::string cell(double value) { return "," + (std::isfinite(value) ? slab::exactly(value) : ""); }

std::string comparison(const TynEstimate &exact, double deviation) {
  return cell(exact.value) + cell(exact.standard_error) + cell(deviation);
}

} // namespace

std::string to_csv(const Arguments &arguments, const Results &results) {
  const bool compare = arguments.compare;
  const ExactResults &exact = results.exact;
  std::string text = "model,channel,quantity,radius,value";
  text += compare ? ",exact,exact_standard_error,error\n" : "\n";
  for (const ModelResults &model : results.models)
    for (size_t c = 0; c < arguments.channels(); ++c) {
      const std::string name = model.name + "," + results.channel_names[c];
      for (size_t i = 0; i < arguments.radii.size(); ++i) {
        text += name + ",profile" + cell(arguments.radii[i]) + cell(model.profile[c][i]);
        if (compare)
          text += comparison({exact.profile[c].values[i], exact.profile[c].errors[i]}, model.deviation[c].values[i]);
        text += "\n";
      }
      text += name + ",albedo," + cell(model.albedo[c]);
      if (compare)
        text += comparison(exact.albedo[c], model.albedo_deviation[c].value);
      text += "\n";
    }
  return text;
}

} // namespace profile
