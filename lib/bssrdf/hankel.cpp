// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
// J_0 is the real part of Hankel's function H_0^(1), which falls off exponentially above the real axis. So the integral is
// taken along s = t exp(i pi / 4), where nothing oscillates for long and where H_0^(1) is made of Kelvin's functions
// (Abramowitz & Stegun 1964, eq. 9.9.1 f.):
//   f(r) = 1 / pi^2 int_0^inf (Re F ker(t r) + Im F kei(t r)) t dt.
// The trapezoidal rule over ln t converges exponentially. With radii of the same ratio as the nodes, Kelvin's functions are
// needed at the powers of that ratio only (Siegman 1977, "Quasi fast Hankel transform").
#include "bssrdf/hankel.hpp"

#include <cmath>

#include "core/pi.hpp"

namespace tyn {
namespace {

// t r from 7e-13 to 70, where the functions are 1e-22. What is left out below is of the order of t^2 ln(t r), beside 1 / r^2
// or, where r is small, beside the frequencies at which F ends.
constexpr int LOWEST = -448, HIGHEST = 68;

std::vector<std::complex<double>> kelvin_at_nodes() {
  std::vector<std::complex<double>> values;
  for (int j = LOWEST; j <= HIGHEST; j++)
    values.push_back(kelvin(std::exp(j * HANKEL_STEP)));
  return values;
}

} // namespace

// K_0(z) = int_0^inf exp(-z cosh y) dy (eq. 9.6.24), again by the trapezoidal rule.
std::complex<double> kelvin(double x) {
  constexpr double STEP = 0.03125;
  const std::complex<double> z = std::polar(x, pi / 4);
  std::complex<double> sum = 0.5 * std::exp(-z);
  for (int i = 1; z.real() * (std::cosh(i * STEP) - 1) < 40; i++)
    sum += std::exp(-z * std::cosh(i * STEP));
  return sum * STEP;
}

std::vector<HankelValue> inverse_hankel(const HankelTransform &transform, double first, size_t count) {
  static const std::vector<std::complex<double>> kernel = kelvin_at_nodes();
  // Node j is t = exp(j HANKEL_STEP) / first. Radius i meets those from LOWEST - i to HIGHEST - i.
  const int low = LOWEST - (int(count) - 1);
  std::vector<std::complex<double>> weighted; // F t^2 dln t / pi^2
  for (int j = low; j <= HIGHEST; j++) {
    const double t = std::exp(j * HANKEL_STEP) / first;
    weighted.push_back(transform(std::polar(t, pi / 4)) * (t * t * HANKEL_STEP / (pi * pi)));
  }
  std::vector<HankelValue> values;
  for (size_t i = 0; i < count; i++) {
    const std::complex<double> *at = &weighted[count - 1 - i];
    HankelValue sum{0, 0};
    for (size_t j = 0; j < kernel.size(); j++) {
      const double real = at[j].real() * kernel[j].real(), imaginary = at[j].imag() * kernel[j].imag();
      sum.value += real + imaginary;
      sum.magnitude += std::abs(real) + std::abs(imaginary);
    }
    values.push_back(sum);
  }
  return values;
}

} // namespace tyn
