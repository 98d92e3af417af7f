// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
#include "bssrdf/escape_angles.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "core/pi.hpp"
#include "kernels/shared_bssrdf.h"
#include "media/fresnel.hpp"
#include "slab/gauss.hpp"

namespace tyn {
namespace {

constexpr uint32_t COLUMNS = TYN_ESCAPE_ANGLES;
static_assert(COLUMNS == TYN_ANGLES_COLUMNS, "the walks are counted in the steps of the table");
constexpr uint32_t RINGS = 8 / TYN_ANGLES_ROWS_PER_OCTAVE; // of a row
constexpr double KNOWN = 0.01; // relative error of all angles together from which on a row stands for itself

using Row = std::array<double, COLUMNS>;

double cosine_of(double column) { return std::sqrt(column / COLUMNS); }

// int f(mu) (1 - F(mu)) mu dmu over the squared cosines of the columns from..to.
template <class F>
double through(double ior, double from, double to, F &&f) {
  static const Quadrature rule = gauss_legendre(8);
  double sum = 0;
  for (size_t i = 0; i < rule.points.size(); ++i) {
    // a square root at grazing angles is taken away
    const double root = std::sqrt(from) + (std::sqrt(to) - std::sqrt(from)) * rule.points[i], column = root * root;
    const double step = rule.weights[i] * 2 * root * (std::sqrt(to) - std::sqrt(from)) / (2 * COLUMNS); // mu dmu
    sum += step * f(column) * (1 - fresnel_reflectance(cosine_of(column), ior));
  }
  return sum;
}

// The lobe's power in each column.
Row lobe_shares(double ior) {
  Row shares{};
  for (uint32_t i = 0; i < COLUMNS; ++i)
    shares[i] = through(ior, i, i + 1, [](double) { return 1.0; });
  const double all = std::accumulate(shares.begin(), shares.end(), 0.0);
  for (double &share : shares)
    share /= all;
  return shares;
}

// Single scattering's power between two radii.
Row single_power(const SingleScattering &single, double from, double to) {
  static const Quadrature rule = gauss_legendre(2);
  Row power{};
  for (size_t i = 0; i < rule.points.size(); ++i) {
    const double r = from * std::pow(to / from, rule.points[i]);
    for (uint32_t angle = 0; angle < COLUMNS; ++angle)
      power[angle] += rule.weights[i] * std::log(to / from) * 2 * pi * r * r *
                      single.exitance_between(r, cosine_of(angle), cosine_of(angle + 1));
  }
  return power;
}

// Between the columns' middles linear, as the kernel has it.
double interpolated(const Row &row, double column) {
  const double at = std::clamp(column - 0.5, 0.0, double(COLUMNS - 1));
  const size_t i = std::min(size_t(at), size_t(COLUMNS - 2));
  return row[i] + (at - double(i)) * (row[i + 1] - row[i]);
}

// Over the lobe's shares, and so that the lobe times what is interpolated has the power of the lobe.
Row quotients(const Row &power, const Row &lobe, double ior) {
  Row row{};
  const double all = std::accumulate(power.begin(), power.end(), 0.0);
  // columns beyond the critical angle, where the outside is denser, have what their lit neighbour has
  double lit = 1;
  for (uint32_t i = COLUMNS; i-- > 0;) {
    if (all > 0 && lobe[i] > 0)
      lit = power[i] / all / lobe[i];
    row[i] = lit;
  }
  double with = 0, without = 0;
  for (uint32_t half = 0; half < 2 * COLUMNS; ++half) {
    with += through(ior, 0.5 * half, 0.5 * (half + 1), [&](double column) { return interpolated(row, column); });
    without += through(ior, 0.5 * half, 0.5 * (half + 1), [](double) { return 1.0; });
  }
  for (double &value : row)
    value *= without / with;
  return row;
}

// The rows' sums, so long as what is summed is not known well.
class Sum {
public:
  void add(const EscapeGrid &grid, const EscapeLight &light, const SingleScattering &single, uint32_t first) {
    for (uint32_t radius = first; radius < first + RINGS; ++radius)
      for (uint32_t angle = 0; angle < COLUMNS; ++angle) {
        power[angle] += light.power[radius * COLUMNS + angle];
        variance += light.variance[radius * COLUMNS + angle];
      }
    const Row once = single_power(single, escape_border(grid.first_radius + first),
                                  escape_border(grid.first_radius + first + RINGS));
    for (uint32_t angle = 0; angle < COLUMNS; ++angle)
      power[angle] += once[angle];
  }

  bool known() const {
    const double all = std::accumulate(power.begin(), power.end(), 0.0);
    return all > 0 && std::sqrt(variance) < KNOWN * all;
  }

  Row power{};

private:
  double variance = 0;
};

} // namespace

std::vector<double> angle_terms(const ExactTable &table, double absorption, const EscapeLight &light,
                                const SingleScattering &single, double ior, double paths) {
  const EscapeGrid &grid = table.escapes.grid;
  const std::array<double, ExactTable::COSINES> entries = table.entries_at(absorption);
  const uint32_t rows = (grid.radii - 1) / RINGS;
  const Row lobe = lobe_shares(ior);
  std::vector<double> terms(TYN_ANGLES_VALUES);
  terms[TYN_ANGLES_FIRST] = std::log2(escape_border(grid.first_radius) / paths) + 0.5 / TYN_ANGLES_ROWS_PER_OCTAVE;
  terms[TYN_ANGLES_ROWS] = rows;
  std::copy(entries.begin(), entries.end(), terms.begin() + TYN_ANGLES_ENTRY);
  Sum sum;
  Row last{};
  last.fill(1);
  for (uint32_t row = 0, waiting = 0; row < rows; ++row) {
    sum.add(grid, light, single, row * RINGS);
    ++waiting;
    if (!sum.known() && row + 1 < rows)
      continue;
    if (sum.known())
      last = quotients(sum.power, lobe, ior);
    for (; waiting > 0; --waiting)
      terms.insert(terms.end(), last.begin(), last.end());
    sum = {};
  }
  return terms;
}

} // namespace tyn
