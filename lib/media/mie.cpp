// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
// Bohren & Huffman, "Absorption and Scattering of Light by Small Particles", 1983 (BH). Their program of appendix A, except for
// two things: psi_n beyond its turning point comes from ratios, which recur downward without loss, and the smallest spheres
// have series, where the coefficients are differences of nearly equal numbers.
#include "media/mie.hpp"

#include <algorithm>
#include <cmath>

#include "core/pi.hpp"
#include "core/argument.hpp"

namespace tyn {
namespace {

using Complex = std::complex<double>;

constexpr double small_sphere = 1e-2; // of x max(1, |m|); the series then are good to 1e-11

// Wiscombe 1980, "Improved Mie scattering algorithms", eq. 22, stops where |a_n|^2 + |b_n|^2 < 5e-14, which leaves 1e-8 of the light
// scattered back by x = 100: about 4 x^(1/3) terms beyond x. The terms fall off as exp(-4 sqrt(2) / 3 c^(3/2)) at x + c x^(1/3).
size_t term_count(double x) { return size_t(std::ceil(x + 6 * std::cbrt(x))) + 3; }

// Logarithmic derivatives D_n = psi_n' / psi_n for n = 1 .. count, at [n], by BH eq. 4.89 downward. An arbitrary start is forgotten
// by exp(-4 sqrt(2) / 3 c^(3/2)) over the c |z|^(1/3) orders before the turning point n = |z|: 1e-18 for c = 8.
template <class T>
std::vector<T> logarithmic_derivatives(T z, size_t count) {
  const double size = std::abs(z);
  const size_t start = std::max(count, size_t(size + 8 * std::cbrt(size))) + 16;
  std::vector<T> result(count + 1);
  T d = 0;
  for (size_t n = start; n > 1; n--) { // d is D_n
    if (n <= count)
      result[n] = d;
    const T ratio = double(n) / z;
    T sum = d + ratio; // psi_(n-1) / psi_n
    if (sum == T(0))
      sum = 1e-200;
    d = ratio - T(1) / sum;
  }
  result[1] = d;
  return result;
}

// psi_0 .. psi_count: upward where that is stable, then by ratios.
std::vector<double> riccati_bessel_psi(double x, size_t count) {
  const std::vector<double> d = logarithmic_derivatives(x, count);
  std::vector<double> psi(count + 1);
  psi[0] = std::sin(x);
  for (size_t n = 1; n <= count; n++) {
    const double order = double(n);
    if (order < x)
      psi[n] = n == 1 ? psi[0] / x - std::cos(x) : (2 * order - 1) / x * psi[n - 1] - psi[n - 2];
    else
      psi[n] = psi[n - 1] / (order / x + d[n]);
  }
  return psi;
}

// a_1, b_1 and a_2, divided by x^3 (Wiscombe 1980, section on small particles, whose i is our -i as his m is n - i k; b_2 is smaller
// by another x^2).
MieSeries small_series(double x, Complex m) {
  const Complex i(0, -1), m2 = m * m, contrast = m2 - 1.0;
  const double x2 = x * x;
  const Complex damping = 2.0 / 3.0 * i * contrast * x2 * x * (1 - x2 / 10);
  const Complex denominator =
      m2 + 2.0 + (1.0 - 0.7 * m2) * x2 - (8.0 * m2 * m2 - 385.0 * m2 + 350.0) * (x2 * x2 / 1400) + damping;
  MieSeries series;
  series.x = x;
  series.absorbs = m.imag() > 0;
  series.scale = x2 * x;
  series.a = {2.0 / 3.0 * i * contrast * (1 - x2 / 10 + (4.0 * m2 + 5.0) * (x2 * x2 / 1400)) / denominator,
              i * contrast * (x2 / 15) * (1 - x2 / 14) / (2.0 * m2 + 3.0 - (2.0 * m2 - 7.0) * (x2 / 14))};
  series.b = {i * contrast * (x2 / 45) * (1.0 + (2.0 * m2 - 5.0) * (x2 / 70)) / (1.0 - (2.0 * m2 - 5.0) * (x2 / 30)),
              0.0};
  return series;
}

// BH eq. 4.88. xi_n = psi_n - i chi_n, and chi recurs upward, the way it grows.
MieSeries full_series(double x, Complex m) {
  const size_t count = term_count(x);
  const std::vector<Complex> d = logarithmic_derivatives(m * x, count);
  const std::vector<double> psi = riccati_bessel_psi(x, count);
  MieSeries series;
  series.x = x;
  series.absorbs = m.imag() > 0;
  series.a.resize(count);
  series.b.resize(count);
  double chi_before = -std::sin(x), chi = std::cos(x); // chi_(n-2), chi_(n-1)
  for (size_t n = 1; n <= count; n++) {
    const double order = double(n);
    const double chi_next = (2 * order - 1) / x * chi - chi_before;
    const Complex xi(psi[n], -chi_next), xi_before(psi[n - 1], -chi);
    const Complex p = d[n] / m + order / x, q = d[n] * m + order / x;
    series.a[n - 1] = (p * psi[n] - psi[n - 1]) / (p * xi - xi_before);
    series.b[n - 1] = (q * psi[n] - psi[n - 1]) / (q * xi - xi_before);
    chi_before = chi;
    chi = chi_next;
  }
  return series;
}

double product(Complex a, Complex b) { return a.real() * b.real() + a.imag() * b.imag(); } // Re(a b*)

// Sum of (2 n + 1) (|a_n|^2 + |b_n|^2) / scale^2: x^2 Q_sca / 2.
double scattered(const MieSeries &series) {
  double sum = 0;
  for (size_t i = series.a.size(); i-- > 0;)
    sum += double(2 * i + 3) * (std::norm(series.a[i]) + std::norm(series.b[i]));
  return sum;
}

// The mean cosine times scattered() (BH, p. 120).
double scattered_cosine(const MieSeries &series) {
  double sum = 0;
  for (size_t i = series.a.size(); i-- > 0;) {
    const double n = double(i + 1);
    sum += (2 * n + 1) / (n * (n + 1)) * product(series.a[i], series.b[i]);
    if (i + 1 < series.a.size())
      sum += n * (n + 2) / (n + 1) * (product(series.a[i], series.a[i + 1]) + product(series.b[i], series.b[i + 1]));
  }
  return 2 * sum;
}

constexpr size_t block = 64; // angles at a time, so that the compiler finds loops to vectorize

// S_1 and S_2 at up to `block` cosines (BH eq. 4.74; pi_n and tau_n by eq. 4.47).
void add_block(const MieSeries &series, const double *cosines, size_t count, double *intensities) {
  double mu[block] = {}, before[block] = {}, now[block];
  double re1[block] = {}, im1[block] = {}, re2[block] = {}, im2[block] = {};
  std::copy_n(cosines, count, mu);
  std::fill_n(now, block, 1.0);
  for (size_t i = 0; i < series.a.size(); i++) {
    const double n = double(i + 1), weight = (2 * n + 1) / (n * (n + 1)), up = (n + 1) / n;
    const Complex a = weight * series.a[i], b = weight * series.b[i];
    const double ar = a.real(), ai = a.imag(), br = b.real(), bi = b.imag();
    for (size_t j = 0; j < block; j++) {
      const double s = mu[j] * now[j], t = s - before[j], tau = n * t - before[j];
      re1[j] += ar * now[j] + br * tau;
      im1[j] += ai * now[j] + bi * tau;
      re2[j] += ar * tau + br * now[j];
      im2[j] += ai * tau + bi * now[j];
      before[j] = now[j];
      now[j] = s + up * t;
    }
  }
  for (size_t j = 0; j < count; j++)
    intensities[j] = 0.5 * (re1[j] * re1[j] + im1[j] * im1[j] + re2[j] * re2[j] + im2[j] * im2[j]);
}

} // namespace

std::complex<double> read_relative_index(const double *index) {
  require_pointer("relative_index", index);
  require_positive("relative_index[0]", index[0]);
  require_not_negative("relative_index[1]", index[1]);
  require_between("the modulus of relative_index", std::hypot(index[0], index[1]), min_relative_index,
                  max_relative_index);
  return {index[0], index[1]};
}

MieSeries mie_series(double x, Complex m) {
  return x * std::max(1.0, std::abs(m)) < small_sphere ? small_series(x, m) : full_series(x, m);
}

TynMie mie_efficiencies(const MieSeries &series) {
  Complex forward = 0, backward = 0;
  for (size_t i = series.a.size(); i-- > 0;) {
    const double weight = double(2 * i + 3);
    forward += weight * (series.a[i] + series.b[i]);
    backward += (i % 2 ? weight : -weight) * (series.a[i] - series.b[i]);
  }
  const double per_area = series.scale / series.x; // both twice, without underflow on the way
  const double sum = scattered(series);
  TynMie mie{};
  mie.q_sca = 2 * sum * per_area * per_area;
  mie.q_ext = 2 * forward.real() * per_area / series.x;
  mie.q_back = std::norm(backward) * per_area * per_area;
  mie.q_abs = series.absorbs ? std::max(0.0, mie.q_ext - mie.q_sca) : 0.0;
  mie.mean_cosine = sum > 0 ? scattered_cosine(series) / sum : 0.0;
  return mie;
}

void mie_intensities(const MieSeries &series, const double *cosines, size_t count, double *intensities) {
  for (size_t begin = 0; begin < count; begin += block)
    add_block(series, cosines + begin, std::min(block, count - begin), intensities + begin);
}

void mie_phase_function(const MieSeries &series, const double *cosines, size_t count, double *values) {
  const double sum = scattered(series);
  if (!(sum > 0)) {
    std::fill_n(values, count, 1 / (4 * pi));
    return;
  }
  mie_intensities(series, cosines, count, values);
  for (size_t i = 0; i < count; i++)
    values[i] /= 2 * pi * sum;
}

} // namespace tyn
