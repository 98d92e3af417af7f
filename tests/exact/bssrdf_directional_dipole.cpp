// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
// The directional dipole against the formulas of Frisvad, Hachisuka, Kjeldsen 2014, written out once more in double precision
// with vectors, where kernels use what follows from the plane of the image; and against figures of another program.
#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "common/bssrdf_model.hpp"
#include "common/bssrdf_paths.hpp"

namespace {

using namespace tyn_test;

constexpr double pi = 3.14159265358979323846;

struct Vector {
  double x, y, z;
};

Vector operator+(Vector a, Vector b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
Vector operator-(Vector a, Vector b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
Vector operator*(double s, Vector a) { return {s * a.x, s * a.y, s * a.z}; }
double dot(Vector a, Vector b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
Vector cross(Vector a, Vector b) { return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x}; }
double length(Vector a) { return std::sqrt(dot(a, a)); }
Vector unit(Vector a) { return 1 / length(a) * a; }
Vector vector(const float (&v)[3]) { return {double(v[0]), double(v[1]), double(v[2])}; }

// int_0^1 F(mu) mu^power dmu by the midpoint rule over a substitution that takes the root at the critical angle away.
double moment(double ior, int power) {
  const double critical = ior < 1 ? std::sqrt(1 - ior * ior) : 0;
  constexpr int STEPS = 20000;
  double sum = std::pow(critical, power + 1) / (power + 1);
  for (int i = 0; i < STEPS; ++i) {
    const double t = (i + 0.5) / STEPS, mu = critical + (1 - critical) * t * t;
    sum += (1 - transmittance(mu, ior)) * std::pow(mu, power) * 2 * (1 - critical) * t / STEPS;
  }
  return sum;
}

class Reference {
public:
  Reference(double sigma_a, double sigma_s, double g, double ior)
      : eta(ior), sigma_t(sigma_a + sigma_s), reduced_t(sigma_a + sigma_s * (1 - g)),
        albedo(sigma_s * (1 - g) / reduced_t), d(1 / (3 * reduced_t)), sigma_tr(std::sqrt(sigma_a / d)),
        d_e(2.131 * d / std::sqrt(albedo)), c_phi(0.25 * (1 - 2 * moment(1 / ior, 1))),
        c_phi_outside(0.25 * (1 - 2 * moment(ior, 1))), c_e(0.5 * (1 - 3 * moment(1 / ior, 2))) {}

  struct Value {
    double s, terms, mu_0; // S, the sum of the magnitudes of its terms, and the cosine by which the surface is lit
  };

  Value operator()(const TynBssrdfPath &path) const {
    const Vector x_i = vector(path.entry_position), n_i = unit(vector(path.entry_normal));
    const Vector x_o = vector(path.exit_position), n_o = unit(vector(path.exit_normal));
    const Vector w_i = unit(vector(path.entry_direction)), w_o = unit(vector(path.exit_direction));
    const double cos_i = -dot(w_i, n_i), cos_o = dot(w_o, n_o);
    const Vector tangent = 1 / eta * (w_i + cos_i * n_i);
    const Vector w_12 = tangent - std::sqrt(1 - dot(tangent, tangent)) * n_i;

    const Vector x = x_o - x_i;
    const double r = length(x), a = (1 - c_e) / (2 * c_phi);
    const Vector n_star = r == 0 ? n_i : cross(unit(x), unit(cross(n_i, x)));
    const Vector x_v = x_i + 2 * a * d_e * n_star, w_v = w_12 - 2 * dot(w_12, n_star) * n_star;

    const double mu_0 = -dot(n_o, w_12);
    const double cos_beta = -std::sqrt((r * r - dot(x, w_12) * dot(x, w_12)) / (r * r + d_e * d_e));
    const double more = mu_0 > 0 ? d * mu_0 * (d * mu_0 - 2 * d_e * cos_beta) : 1 / (9 * sigma_t * sigma_t);
    double terms = 0;
    const double source = infinite(x, w_12, std::sqrt(r * r + more), n_o, terms);
    const double image = infinite(x_o - x_v, w_v, length(x_o - x_v), n_o, terms);
    const double through = transmittance(cos_i, eta) * transmittance(cos_o, eta);
    return {through * std::max(source - image, 0.0), through * terms, mu_0};
  }

  // R of perpendicular light on a plane.
  double profile(double r) const {
    const Value value = (*this)(plane_path(r));
    return 4 * pi * c_phi_outside * value.s / std::pow(transmittance(1, eta), 2);
  }

private:
  // S' of the paper.
  double infinite(Vector x, Vector w, double r, Vector n_o, double &terms) const {
    const double tr = sigma_tr * r, scale = std::exp(-tr) / (r * r * r) / (4 * c_phi_outside * 4 * pi * pi);
    const double parts[5] = {c_phi * r * r / d, c_phi * 3 * (1 + tr) * dot(x, w), -c_e * 3 * d * (1 + tr) * dot(w, n_o),
                             c_e * (1 + tr) * dot(x, n_o),
                             c_e * 3 * d * (3 * (1 + tr) + tr * tr) / (r * r) * dot(x, w) * dot(x, n_o)};
    double sum = 0;
    for (double part : parts) {
      sum += scale * part;
      terms += scale * std::abs(part);
    }
    return sum;
  }

  const double eta, sigma_t, reduced_t, albedo, d, sigma_tr, d_e, c_phi, c_phi_outside, c_e;
};

BssrdfModel directional_dipole(double sigma_a, double sigma_s, double g, double ior) {
  TynBssrdfOptions options = tyn_bssrdf_options();
  options.model = TYN_BSSRDF_DIRECTIONAL_DIPOLE;
  ExactSlab slab({{sigma_a, sigma_s, g, ior, INFINITY}});
  return BssrdfModel(slab.view(), options);
}

// 4000 configurations of each of 60 media, of mean free paths from 1e-6 to 50 000. Where terms of both signs nearly cancel a
// float keeps fewer digits.
TEST(DirectionalDipole, IsTheFormulaOfThePaper) {
  size_t lit = 0, behind = 0, dark = 0;
  for (double albedo : {0.1, 0.5, 0.9, 0.99, 1.0})
    for (double ior : {1.0, 1.33, 1.5, 3.0})
      for (double g : {0.0, 0.8, -0.4}) {
        const double scale = albedo == 0.9 ? 2e-5 : albedo == 0.5 ? 1e6 : 1, reduced_t = scale; // 1 / length
        const double sigma_a = (1 - albedo) * reduced_t, sigma_s = albedo * reduced_t / (1 - g);
        const BssrdfModel model = directional_dipole(sigma_a, sigma_s, g, ior);
        const Reference reference(sigma_a, sigma_s, g, ior);
        const std::vector<TynBssrdfPath> paths = random_paths(4000, 5, 1e-3 / scale, 30 / scale);
        const std::vector<float> values = model.evaluate(paths);
        for (size_t i = 0; i < paths.size(); ++i) {
          const Reference::Value expected = reference(paths[i]);
          if (std::abs(expected.mu_0) < 1e-5)
            continue; // where it jumps
          (expected.mu_0 > 0 ? lit : behind)++;
          dark += expected.s == 0;
          ASSERT_NEAR(double(values[i]), expected.s, 1e-4 * expected.s + 6e-6 * expected.terms)
              << albedo << " " << ior << " " << g << " " << i;
        }
      }
  EXPECT_GT(lit, 80000u);
  EXPECT_GT(behind, 80000u);
  EXPECT_GT(dark, 10000u);
  EXPECT_LT(dark, 160000u);
}

// Oblique light on a plane, farther away than what the other terms are about.
TEST(DirectionalDipole, IsTheFormulaOnAPlane) {
  for (double albedo : {0.5, 0.99, 1.0})
    for (double ior : {1.0, 1.4}) {
      const BssrdfModel model = directional_dipole(1 - albedo, albedo, 0, ior);
      const Reference reference(1 - albedo, albedo, 0, ior);
      for (double r : {1e-6, 1e-3, 0.1, 1.0, 10.0, 40.0, 1e3, 1e5})
        for (double entry : {-1.5, -0.7, 0.0, 0.3, 1.2, 1.5}) {
          const TynBssrdfPath path = plane_path(r, entry, 0.5);
          const double expected = reference(path).s;
          EXPECT_NEAR(double(model.evaluate({path})[0]), expected, 1e-4 * expected + 1e-36)
              << albedo << " " << r << " " << entry;
        }
    }
}

// Of a Python program of the same formulas for perpendicular light only, R at 0.01, 0.1, 1, 5 and 20 mean free paths.
TEST(DirectionalDipole, HasTheProfileOfAnotherProgram) {
  const double radii[] = {0.01, 0.1, 1, 5, 20};
  const struct {
    double albedo, ior, profile[5];
  } rows[] = {{0.5, 1, {1.030609e+00, 5.219184e-01, 2.100893e-02, 2.541263e-05, 2.412771e-14}},
              {0.9, 1.33, {7.260565e-01, 3.794491e-01, 2.525297e-02, 3.871512e-04, 1.052127e-08}},
              {0.99, 1, {1.132873e+00, 6.059518e-01, 5.354177e-02, 1.432689e-03, 4.552126e-06}},
              {0.99, 1.4, {6.756624e-01, 3.585312e-01, 3.022655e-02, 1.588629e-03, 8.059020e-06}},
              {1, 3, {1.291812e-01, 6.862438e-02, 6.334788e-03, 8.504227e-04, 1.220094e-04}}};
  for (const auto &row : rows) {
    const BssrdfModel model = directional_dipole(1 - row.albedo, row.albedo, 0, row.ior);
    const Reference reference(1 - row.albedo, row.albedo, 0, row.ior);
    for (int i = 0; i < 5; ++i) {
      EXPECT_NEAR(double(model.profile({float(radii[i])})[0]), row.profile[i], 5e-5 * row.profile[i]) << row.albedo;
      EXPECT_NEAR(reference.profile(radii[i]), row.profile[i], 2e-5 * row.profile[i]) << row.albedo;
    }
  }
}

// Its totals are above what there is, by the same program.
TEST(DirectionalDipole, HasTheTotalsOfAnotherProgram) {
  const double rows[][3] = {{1e-4, 0.2105, 0.1200},
                            {0.5, 0.3490, 0.1937},
                            {0.8, 0.5548, 0.3073},
                            {0.95, 0.8485, 0.5314},
                            {0.99, 1.0866, 0.8040}};
  for (const auto &row : rows)
    for (int i = 0; i < 2; ++i)
      EXPECT_NEAR(half_space_model(TYN_BSSRDF_DIRECTIONAL_DIPOLE, row[0], i ? 1.4 : 1).albedo()[0], row[1 + i], 3e-4);
}

// On a plane, light that comes in aslant goes on: more of it leaves ahead than behind.
TEST(DirectionalDipole, KnowsWhereLightCameFrom) {
  const BssrdfModel model = directional_dipole(0.1, 0.9, 0, 1.3);
  const std::vector<float> values = model.evaluate({plane_path(1, 1, 0), plane_path(1, -1, 0)});
  EXPECT_GT(values[0], 1.5f * values[1]);
}

// Where the points are the same the image is above the surface's own tangent plane: the limit of neighbouring ones.
TEST(DirectionalDipole, IsContinuousWhereLightGetsIn) {
  for (double ior : {1.0, 1.4}) {
    const BssrdfModel model = directional_dipole(0.1, 0.9, 0.3, ior);
    const Reference reference(0.1, 0.9, 0.3, ior);
    for (double entry : {0.0, 0.8, 1.4}) {
      const double expected = reference(plane_path(0, entry)).s;
      EXPECT_GT(expected, 0);
      EXPECT_NEAR(double(model.evaluate({plane_path(0, entry)})[0]), expected, 1e-4 * expected);
      EXPECT_NEAR(double(model.evaluate({plane_path(1e-6, entry)})[0]), expected, 1e-3 * expected);
    }
  }
}

} // namespace
