// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
#include "bssrdf/profile.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "bssrdf/integrate.hpp"
#include "bssrdf/monotone.hpp"
#include "core/pi.hpp"

namespace tyn {
namespace {

double pairs_value(const Profile &p, double x) {
  double sum = 0;
  for (uint32_t i = 0; i < p.count; i++) {
    const PairLight light = pair_light({p.terms[3 * i], p.terms[3 * i + 1]}, p.falloff, x);
    sum += p.flux * light.flux + p.fluence * light.fluence;
  }
  return sum;
}

double gaussians_value(const Profile &p, double x) {
  double sum = 0;
  for (uint32_t i = 0; i < p.count; i++)
    sum += p.terms[2 * i] * std::exp(-p.terms[2 * i + 1] * x * x);
  return sum;
}

// Of the borders 1 .. TYN_SAMPLER_CELLS - 2 the last that is not above x, or the first.
uint32_t border_below(double x) {
  uint32_t k = 1, end = TYN_SAMPLER_CELLS - 1;
  while (end - k > 1) {
    const uint32_t middle = (k + end) / 2;
    (sampler_border(middle) <= x ? k : end) = middle;
  }
  return k;
}

// The cubics of profile_table in kernels/bssrdf_profile.clh.
double table_value(const Profile &p, double x) {
  const double first = sampler_border(1), last = sampler_border(TYN_SAMPLER_CELLS - 1);
  if (x <= first)
    return p.flux * std::exp(p.terms[0]) * (p.fluence > 0 ? first / x : 1);
  if (x >= last) {
    const double ratio = last / x;
    return p.flux * std::exp(p.terms[2 * (p.count - 1)] - p.falloff * (x - last)) * ratio * ratio * ratio;
  }
  const uint32_t k = border_below(x);
  const double *from = &p.terms[2 * (k - 1)], *to = from + 2;
  const double borders[] = {sampler_border(k), sampler_border(k + 1)};
  const double values[] = {from[0], to[0]}, slopes[] = {from[1], to[1]};
  return p.flux * std::exp(hermite(borders, values, slopes, x));
}

// int 2 pi x R dx from `begin` to `end`.
double ring(const Profile &p, double begin, double end) {
  return integrate([&](double x) { return 2 * pi * x * profile_value(p, x); }, begin, end);
}

// The same from 2^12 on: over 1 / x.
double beyond(const Profile &p) {
  const double last = sampler_border(TYN_SAMPLER_CELLS - 1);
  return integrate([&](double w) { return w > 0 ? 2 * pi * profile_value(p, 1 / w) / (w * w * w) : 0; }, 0, 1 / last);
}

std::vector<double> ring_integrals(const Profile &p) {
  std::vector<double> rings;
  for (uint32_t k = 0; k + 1 < TYN_SAMPLER_CELLS; k++)
    rings.push_back(ring(p, sampler_border(k), sampler_border(k + 1)));
  rings.push_back(beyond(p));
  return rings;
}

double sum(const std::vector<double> &values) { return std::accumulate(values.begin(), values.end(), 0.0); }

constexpr double FARTHEST = 1e6;

// The fraction of the albedo beyond x, of shapes that have it in closed form.
double tail_of_closed_form(const Profile &p, double x) {
  if (p.kind == TYN_PROFILE_EXPONENTIALS)
    return std::exp(-x) / 4 + 3 * std::exp(-x / 3) / 4;
  double beyond = 0; // a / b is twice the weight over pi
  for (uint32_t i = 0; i < p.count; i++)
    beyond += pi * p.terms[2 * i] / p.terms[2 * i + 1] * std::exp(-p.terms[2 * i + 1] * x * x);
  return beyond / p.albedo;
}

} // namespace

PairLight pair_light(const SourcePair &pair, double falloff, double x) {
  const double d_r = std::hypot(x, pair.z_r), d_v = std::hypot(x, pair.z_v);
  const double e_r = std::exp(-falloff * d_r), e_v = std::exp(-falloff * d_v);
  // e_r / d_r - e_v / d_v, far away of nearly equal numbers
  const double farther =
      (std::abs(pair.z_v) - std::abs(pair.z_r)) * (std::abs(pair.z_v) + std::abs(pair.z_r)) / (d_r + d_v);
  return {pair.z_r * (1 + falloff * d_r) * e_r / (d_r * d_r * d_r) -
              pair.z_v * (1 + falloff * d_v) * e_v / (d_v * d_v * d_v),
          (e_r * farther - d_r * e_r * std::expm1(-falloff * farther)) / (d_r * d_v)};
}

Profile black_profile() { return {}; }

// int 2 pi r g(d) dr = 2 pi exp(-falloff |z|) / |z|, int 2 pi r h(d) dr = 2 pi exp(-falloff |z|) / falloff.
Profile profile_of_pairs(double length, double falloff, double flux, double fluence,
                         const std::vector<SourcePair> &pairs) {
  Profile p;
  p.kind = TYN_PROFILE_PAIRS;
  p.length = length;
  p.falloff = falloff;
  p.flux = flux;
  p.fluence = fluence;
  p.count = uint32_t(pairs.size());
  for (const SourcePair &pair : pairs) {
    const double z_r = std::abs(pair.z_r), z_v = std::abs(pair.z_v), near = std::min(z_r, z_v);
    const double lost = -std::expm1(-falloff * std::abs(z_v - z_r));
    p.terms.insert(p.terms.end(), {pair.z_r, pair.z_v, (z_v - z_r) * (z_v + z_r)});
    p.albedo += 2 * pi * flux *
                (std::copysign(std::exp(-falloff * z_r), pair.z_r) - std::copysign(std::exp(-falloff * z_v), pair.z_v));
    p.albedo += 2 * pi * fluence *
                (falloff > 0 ? std::copysign(std::exp(-falloff * near) * lost / falloff, z_v - z_r) : z_v - z_r);
  }
  return p;
}

Profile profile_of_gaussians(const std::vector<double> &weights, const std::vector<double> &variances) {
  Profile p;
  p.kind = TYN_PROFILE_GAUSSIANS;
  p.length = std::sqrt(*std::max_element(variances.begin(), variances.end()));
  p.count = uint32_t(weights.size());
  for (size_t i = 0; i < weights.size(); i++) {
    const double variance = variances[i] / (p.length * p.length);
    p.terms.insert(p.terms.end(), {weights[i] / (2 * pi * variance), 1 / (2 * variance)});
    p.albedo += weights[i];
  }
  return p;
}

Profile profile_of_exponentials(double length, double albedo) {
  Profile p;
  p.kind = TYN_PROFILE_EXPONENTIALS;
  p.length = length;
  p.flux = albedo / (8 * pi);
  p.albedo = albedo;
  return p;
}

Profile profile_of_table(double length, const std::function<double(double)> &value, bool diverges, double falloff) {
  Profile p;
  p.length = length;
  p.falloff = falloff;
  p.fluence = diverges ? 1 : 0;
  std::vector<double> x, y;
  for (uint32_t k = 1; k < TYN_SAMPLER_CELLS; k++) {
    x.push_back(sampler_border(k));
    y.push_back(value(x.back()));
    p.flux = std::max(p.flux, y.back());
  }
  if (!(p.flux > 0))
    return black_profile();
  // what a float cannot tell from 0 still has a logarithm
  std::transform(y.begin(), y.end(), y.begin(), [&](double r) { return std::log(std::max(r / p.flux, 1e-37)); });
  const std::vector<double> slopes = monotone_slopes(x, y);
  p.count = uint32_t(x.size());
  for (size_t i = 0; i < x.size(); i++)
    p.terms.insert(p.terms.end(), {y[i], slopes[i]});
  p.rings = ring_integrals(p);
  p.albedo = sum(p.rings);
  return p;
}

double profile_value(const Profile &p, double x) {
  switch (p.kind) {
  case TYN_PROFILE_PAIRS:
    return pairs_value(p, x);
  case TYN_PROFILE_GAUSSIANS:
    return gaussians_value(p, x);
  case TYN_PROFILE_EXPONENTIALS:
    return p.flux * (std::exp(-x) + std::exp(-x / 3)) / x;
  default:
    return p.count ? table_value(p, x) : 0;
  }
}

double profile_error(const Profile &p, double x) { return p.errors.empty() ? 0 : p.errors[border_below(x) - 1]; }

void scale_profile(Profile &p, double factor) {
  p.flux *= factor;
  p.albedo *= factor;
  for (double &ring : p.rings)
    ring *= factor;
}

double sampler_border(uint32_t k) {
  if (k == 0)
    return 0;
  const uint32_t number = k + TYN_SAMPLER_FIRST - 1;
  return std::ldexp(double(32 + (number & 31)), int(number >> 5) - 127 - 5);
}

std::vector<double> sampler_chances(const Profile &profile) {
  const std::vector<double> rings = profile.rings.empty() ? ring_integrals(profile) : profile.rings;
  const double all = sum(rings);
  std::vector<double> chances(1, 0.0);
  for (double ring : rings)
    chances.push_back(chances.back() + ring / all);
  chances.back() = 1;
  return chances;
}

double profile_reach(const Profile &p, const std::vector<double> &chances, double tail) {
  if (!(p.albedo > 0))
    return 0;
  if (p.kind == TYN_PROFILE_GAUSSIANS || p.kind == TYN_PROFILE_EXPONENTIALS) {
    double low = 0, high = FARTHEST;
    for (int i = 0; i < 64; i++) {
      const double middle = 0.5 * (low + high);
      (tail_of_closed_form(p, middle) > tail ? low : high) = middle;
    }
    return high;
  }
  uint32_t k = 1;
  while (k + 1 < TYN_SAMPLER_CELLS && 1 - chances[k] > tail)
    k++;
  // what is beyond x in the last cell, which has no end, is like 1 / x
  return sampler_border(k) * std::min(std::max((1 - chances[k]) / tail, 1.0), FARTHEST);
}

} // namespace tyn
