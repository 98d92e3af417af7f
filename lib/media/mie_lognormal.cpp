// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
// Means over log-normal radii. In t = log(radius) the integrand is a normal density times r^2 Q(r): smooth but for the ripples of Q.
// The trapezoidal rule converges on such an integrand as fast as any; its step is halved until the means stand still.
#include "media/mie_lognormal.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/pi.hpp"
#include "core/argument.hpp"

namespace tyn {
namespace {

constexpr double negligible = 22; // in logarithms: e^-22 = 3e-10 of the largest part
// Relative changes from one step to its half below which that is good enough; the error left is smaller than they are.
constexpr double cross_section_change = 1e-6, value_change = 1e-4;
constexpr double max_work = 1e10; // terms times angles: some ten seconds
constexpr int first_intervals = 64, max_halvings = 14;

struct Range {
  double begin, end; // of t
};

// Logarithm of the integrand, up to a factor of order 1, with Q taken as min(1, x^power).
double log_part(double t, double median, double deviation, double log_k, double power) {
  const double z = (t - median) / deviation;
  return -0.5 * z * z + 2 * t + power * std::min(0.0, t + log_k);
}

// Where the integrand is not negligible: it has its peak between the median and (2 + power) deviation^2 above it.
Range range_of(double median, double deviation, double log_k, double power) {
  const double highest = median + (2 + power) * deviation * deviation;
  double peak = -INFINITY;
  for (int i = 0; i <= 1000; i++)
    peak = std::max(peak, log_part(median + (highest - median) * i / 1000, median, deviation, log_k, power));
  const double width = std::sqrt(2 * negligible) * deviation;
  Range range{highest, median};
  for (int i = 0; i <= 4000; i++) {
    const double t = median - width + (highest - median + 2 * width) * i / 4000;
    if (log_part(t, median, deviation, log_k, power) < peak - negligible)
      continue;
    range.begin = std::min(range.begin, t);
    range.end = std::max(range.end, t);
  }
  return range;
}

// Sums over the points of a rule.
struct Sums {
  double extinction = 0, scattering = 0, absorption = 0, cosine = 0;
  std::vector<double> intensities;
};

class Integral {
public:
  Integral(const TynMieDistribution &given, const double *directions, size_t count)
      : m(read_relative_index(given.relative_index)), median(std::log(given.median_radius)),
        deviation(std::log(given.geometric_deviation)), wave_number(2 * pi / given.wavelength), cosines(directions),
        part(count) {
    sums.intensities.resize(count);
  }

  // The point t with weight 1.
  void add(double t) {
    const double r = std::exp(t), z = (t - median) / deviation;
    const double weight = std::exp(-0.5 * z * z);
    const MieSeries series = mie_series(std::max(wave_number * r, std::numeric_limits<double>::min()), m);
    const TynMie mie = mie_efficiencies(series);
    const double area = weight * pi * r * r;
    sums.extinction += area * mie.q_ext;
    sums.scattering += area * mie.q_sca;
    sums.absorption += area * mie.q_abs;
    sums.cosine += area * mie.q_sca * mie.mean_cosine;
    mie_intensities(series, cosines, part.size(), part.data());
    const double factor = weight * series.scale * series.scale;
    for (size_t i = 0; i < part.size(); i++)
      sums.intensities[i] += factor * part[i];
    work += double(series.a.size()) * double(part.size() + 8);
  }

  MieMeans means(double step) const {
    const double norm = step / (deviation * std::sqrt(2 * pi));
    MieMeans result;
    result.cross_sections = {norm * sums.extinction, norm * sums.scattering, norm * sums.absorption,
                             sums.scattering > 0 ? sums.cosine / sums.scattering : 0.0};
    const double per_solid_angle = 1 / (wave_number * wave_number * sums.scattering);
    for (double intensity : sums.intensities)
      result.values.push_back(intensity * per_solid_angle);
    return result;
  }

  std::complex<double> m;
  double median, deviation, wave_number;
  double work = 0;

private:
  const double *cosines;
  std::vector<double> part;
  Sums sums;
};

bool close(double a, double b, double tolerance) { return std::abs(a - b) <= tolerance * std::abs(b); }

bool close(const MieMeans &a, const MieMeans &b) {
  const TynMieCrossSections &c = a.cross_sections, &d = b.cross_sections;
  bool same = close(c.extinction, d.extinction, cross_section_change) &&
              close(c.scattering, d.scattering, cross_section_change) &&
              close(c.absorption, d.absorption, cross_section_change) &&
              std::abs(c.mean_cosine - d.mean_cosine) <= cross_section_change;
  for (size_t i = 0; i < a.values.size(); i++)
    same = same && close(a.values[i], b.values[i], value_change);
  return same;
}

Range range_of(const Integral &integral) {
  const double log_k = std::log(integral.wave_number);
  const Range scattering = range_of(integral.median, integral.deviation, log_k, 4);
  const Range absorption = range_of(integral.median, integral.deviation, log_k, 1);
  return {std::min(scattering.begin, absorption.begin), std::max(scattering.end, absorption.end)};
}

MieMeans integrate(Integral &integral) {
  const Range range = range_of(integral);
  const double largest = integral.wave_number * std::exp(range.end);
  if (!(largest <= max_size_parameter))
    fail(TYN_ERROR_INVALID_ARGUMENT, "the distribution reaches size parameters of %g; at most %g is allowed", largest,
         max_size_parameter);
  double step = (range.end - range.begin) / first_intervals;
  for (int i = 0; i <= first_intervals; i++)
    integral.add(range.begin + step * i); // the ends are negligible: their weight does not matter
  MieMeans means = integral.means(step);
  for (int halving = 0, intervals = first_intervals; halving < max_halvings; halving++, intervals *= 2) {
    if (2 * integral.work > max_work)
      break;
    for (int i = 0; i < intervals; i++)
      integral.add(range.begin + step * (i + 0.5));
    step *= 0.5;
    const MieMeans finer = integral.means(step);
    const bool done = close(means, finer);
    means = finer;
    if (done)
      break;
  }
  return means;
}

MieMeans single_sphere(const TynMieDistribution &distribution, const double *cosines, size_t count) {
  const double r = distribution.median_radius, x = 2 * pi * r / distribution.wavelength;
  if (!(x > 0 && x <= max_size_parameter))
    fail(TYN_ERROR_INVALID_ARGUMENT,
         "the size parameter, 2 pi median_radius / wavelength, is %g; it must be in (0, %g]", x, max_size_parameter);
  const MieSeries series = mie_series(x, read_relative_index(distribution.relative_index));
  const TynMie mie = mie_efficiencies(series);
  const double area = pi * r * r;
  MieMeans means;
  means.cross_sections = {area * mie.q_ext, area * mie.q_sca, area * mie.q_abs, mie.mean_cosine};
  means.values.resize(count);
  mie_phase_function(series, cosines, count, means.values.data());
  return means;
}

} // namespace

MieMeans mie_lognormal(const TynMieDistribution &distribution, const double *cosines, size_t count) {
  require_positive("TynMieDistribution::median_radius", distribution.median_radius);
  require_between("TynMieDistribution::geometric_deviation", distribution.geometric_deviation, 1, 5);
  require_positive("TynMieDistribution::wavelength", distribution.wavelength);
  if (std::log(distribution.geometric_deviation) < 1e-9) // narrower than quadrature can tell from one sphere
    return single_sphere(distribution, cosines, count);
  Integral integral(distribution, cosines, count);
  MieMeans means = integrate(integral);
  if (!(means.cross_sections.scattering > 0)) // below double's range: Rayleigh's, or nothing at all
    means.values = single_sphere(distribution, cosines, count).values;
  return means;
}

} // namespace tyn
