// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
// The calls of tyndall_phase.h on spheres. They have no context: errors are statuses only.
#include <algorithm>
#include <cmath>

#include "core/context.hpp"
#include "core/input.hpp"
#include "media/mie.hpp"
#include "core/pi.hpp"
#include "media/mie_lognormal.hpp"

namespace tyn {
namespace {

void require_size_parameter(double x) {
  if (!(x > 0 && x <= max_size_parameter))
    fail(TYN_ERROR_INVALID_ARGUMENT, "size_parameter is %g; it must be in (0, %g]", x, max_size_parameter);
}

void require_directions(const double *cosines, size_t count, const double *values) {
  if (count == 0)
    return;
  require_pointer("cosines", cosines);
  require_pointer("values", values);
  for (size_t i = 0; i < count; i++)
    require_between("cosines", cosines[i], -1, 1);
}

// The share of the angles of a table that lie below `angle`: half of them evenly spread, half even in the logarithm from
// the diffraction peak's width on.
double share_below(double angle, double peak) {
  return 0.5 * angle / pi + 0.5 * std::asinh(angle / peak) / std::asinh(pi / peak);
}

double angle_of_share(double share, double peak) {
  double low = 0, high = pi;
  for (int i = 0; i < 64; i++) {
    const double middle = 0.5 * (low + high);
    (share_below(middle, peak) < share ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

// From the back, as cosines increase; beside 1 they are at least a double's step apart.
std::vector<double> table_cosines(double x, size_t count) {
  const double peak = 1 / std::max(1.0, x);
  std::vector<double> cosines(count);
  cosines[count - 1] = 1;
  for (size_t i = count - 1; i-- > 1;) {
    const double sine = std::sin(0.5 * angle_of_share(double(count - 1 - i) / double(count - 1), peak));
    cosines[i] = std::min(1 - 2 * sine * sine, std::nextafter(cosines[i + 1], -1.0));
  }
  cosines[0] = -1;
  return cosines;
}

} // namespace
} // namespace tyn

using namespace tyn;

extern "C" {

TynStatus tyn_rayleigh_cross_section(double radius, double wavelength, const double relative_index[2],
                                     double *cross_section) {
  return guarded(nullptr, [&] {
    require_not_negative("radius", radius);
    require_positive("wavelength", wavelength);
    const std::complex<double> m = read_relative_index(relative_index), m2 = m * m;
    require_pointer("cross_section", cross_section);
    const double x = 2 * pi * radius / wavelength;
    const double result = 8 * pi / 3 * x * x * radius * (x * x * radius) * std::norm((m2 - 1.0) / (m2 + 2.0));
    require_finite("the cross-section", result);
    *cross_section = result;
  });
}

TynStatus tyn_mie(double size_parameter, const double relative_index[2], TynMie *mie, const double *cosines,
                  size_t count, double *values) {
  return guarded(nullptr, [&] {
    require_size_parameter(size_parameter);
    const std::complex<double> m = read_relative_index(relative_index);
    require_directions(cosines, count, values);
    const MieSeries series = mie_series(size_parameter, m);
    mie_phase_function(series, cosines, count, values);
    if (mie)
      *mie = mie_efficiencies(series);
  });
}

TynStatus tyn_mie_lognormal(const TynMieDistribution *distribution, TynMieCrossSections *cross_sections,
                            const double *cosines, size_t count, double *values) {
  return guarded(nullptr, [&] {
    const TynMieDistribution given = read_struct("TynMieDistribution", distribution, tyn_mie_distribution());
    require_directions(cosines, count, values);
    const MieMeans means = mie_lognormal(given, cosines, count);
    std::copy(means.values.begin(), means.values.end(), values);
    if (cross_sections)
      *cross_sections = means.cross_sections;
  });
}

TynStatus tyn_mie_cosines(double size_parameter, size_t count, double *cosines) {
  return guarded(nullptr, [&] {
    require_size_parameter(size_parameter);
    if (count < 2 || count > 65536)
      fail(TYN_ERROR_INVALID_ARGUMENT, "count is %zu; it must be in 2 .. 65536", count);
    require_pointer("cosines", cosines);
    const std::vector<double> result = table_cosines(size_parameter, count);
    std::copy(result.begin(), result.end(), cosines);
  });
}

} // extern "C"
