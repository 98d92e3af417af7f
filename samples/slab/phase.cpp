// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
#include "slab/phase.hpp"

#include "common/tool.hpp"
#include "slab/parse.hpp"

#include <algorithm>

namespace slab {
namespace {

const char *const kExpected = "isotropic, rayleigh, hg, two-lobe:G1,G2,WEIGHT, draine:G,ALPHA or mie:SIZE,N,K";

// The `count` numbers behind "NAME:"; false if the text is of another kind.
bool parameters(const std::string &text, const std::string &name, size_t count, std::vector<double> &values) {
  if (text.compare(0, name.size() + 1, name + ":") != 0)
    return false;
  values.clear();
  for (const std::string &part : split(text.substr(name.size() + 1), ',')) {
    double value = 0.0;
    if (!parse_number(part, value))
      wrong("--phase", text, kExpected);
    values.push_back(value);
  }
  if (values.size() != count)
    wrong("--phase", text, kExpected);
  return true;
}

bool is_cosine(double g) { return g > -1.0 && g < 1.0; }

void set_two_lobe(const std::string &text, const std::vector<double> &values, TynPhase &phase) {
  if (!is_cosine(values[0]) || !is_cosine(values[1]) || !(values[2] >= 0.0 && values[2] <= 1.0))
    wrong("--phase", text, "mean cosines above -1 and below 1, and the weight of the first lobe from 0 to 1");
  phase.kind = TYN_PHASE_TWO_LOBE;
  phase.g = values[0];
  phase.g2 = values[1];
  phase.weight = values[2];
}

void set_draine(const std::string &text, const std::vector<double> &values, TynPhase &phase) {
  if (!is_cosine(values[0]) || !(values[1] >= 0.0 && values[1] <= 1e6))
    wrong("--phase", text, "g above -1 and below 1, and alpha from 0 to 1e6");
  phase.kind = TYN_PHASE_DRAINE;
  phase.g = values[0];
  phase.alpha = values[1];
}

// The table follows the lobes of the sphere's pattern, of which there are about as many as its size parameter.
void set_mie(const std::string &text, const std::vector<double> &values, PhaseArgument &argument) {
  const double size = values[0];
  if (!(size > 0.0 && size <= 1e5) || !(values[1] > 0.0) || std::isinf(values[1]) || !(values[2] >= 0.0) ||
      std::isinf(values[2]))
    wrong("--phase", text, "a size parameter 2 pi a / lambda above 0, up to 1e5, an index n > 0, and k >= 0");
  const auto count = static_cast<size_t>(std::clamp(1024.0 + 32.0 * size, 1024.0, 65536.0));
  const double index[2] = {values[1], values[2]};
  argument.cosines.resize(count);
  argument.values.resize(count);
  if (tyn_mie_cosines(size, count, argument.cosines.data()) != TYN_OK ||
      tyn_mie(size, index, nullptr, argument.cosines.data(), count, argument.values.data()) != TYN_OK)
    wrong("--phase", text, "a sphere that Lorenz-Mie theory can be computed for");
  argument.phase.kind = TYN_PHASE_TABULATED;
  argument.phase.count = static_cast<uint32_t>(count);
}

} // namespace

PhaseArgument parse_phase(const std::string &text) {
  PhaseArgument argument;
  if (text == "hg")
    return argument;
  argument.given = true;
  argument.text = text;
  std::vector<double> values;
  if (text == "isotropic")
    argument.phase.kind = TYN_PHASE_ISOTROPIC;
  else if (text == "rayleigh")
    argument.phase.kind = TYN_PHASE_RAYLEIGH;
  else if (parameters(text, "two-lobe", 3, values))
    set_two_lobe(text, values, argument.phase);
  else if (parameters(text, "draine", 2, values))
    set_draine(text, values, argument.phase);
  else if (parameters(text, "mie", 3, values))
    set_mie(text, values, argument);
  else
    wrong("--phase", text, kExpected);
  return argument;
}

} // namespace slab
