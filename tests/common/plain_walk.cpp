// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
#include "common/plain_walk.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <thread>

namespace tyn_test {

namespace {

using Vector = float[3];

float dot(const Vector &a, const Vector &b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

void move(Vector &p, const Vector &d, float by) {
  for (int k = 0; k < 3; ++k)
    p[k] += by * d[k];
}

// Fraction of unpolarized light that a smooth interface reflects; `eta` = index beyond it / index before it.
float fresnel(float cosine, float eta) {
  float sine2 = (1 - cosine * cosine) / (eta * eta);
  if (sine2 >= 1)
    return 1;
  float beyond = std::sqrt(1 - sine2);
  float s = (cosine - eta * beyond) / (cosine + eta * beyond);
  float p = (eta * cosine - beyond) / (eta * cosine + beyond);
  return 0.5f * (s * s + p * p);
}

} // namespace

// Sebastiano Vigna's splitmix64: fast, so that Embree's rays are what is measured.
class PlainWalk::Random {
public:
  explicit Random(uint64_t path) : state(path << 32) {}
  // In (0, 1).
  float uniform() {
    uint64_t z = state += 0x9e3779b97f4a7c15u;
    z = (z ^ z >> 30) * 0xbf58476d1ce4e5b9u;
    z = (z ^ z >> 27) * 0x94d049bb133111ebu;
    return (float((z ^ z >> 31) >> 41) + 0.5f) * 0x1p-23f;
  }

private:
  uint64_t state;
};

namespace {

// Turns a direction by a cosine, about itself by any angle: `turn` in [0, 1) (Duff et al. 2017, "Building an Orthonormal Basis,
// Revisited").
void deflect(Vector &d, float cosine, float turn) {
  float phi = 6.2831853f * turn, sine = std::sqrt(std::max(0.0f, 1 - cosine * cosine));
  float a = sine * std::cos(phi), b = sine * std::sin(phi), sign = std::copysign(1.0f, d[2]);
  float k = -1 / (sign + d[2]), m = d[0] * d[1] * k;
  float x = a * (1 + sign * d[0] * d[0] * k) + b * m + cosine * d[0];
  float y = a * sign * m + b * (sign + d[1] * d[1] * k) + cosine * d[1];
  float z = -a * sign * d[0] - b * d[1] + cosine * d[2];
  float scale = 1 / std::sqrt(x * x + y * y + z * z);
  d[0] = x * scale, d[1] = y * scale, d[2] = z * scale;
}

// The cosine of a deflection by Henyey and Greenstein's function.
float henyey_greenstein(float g, float u) {
  if (g == 0)
    return 1 - 2 * u;
  float s = (1 - g * g) / (1 - g + 2 * g * u);
  return (1 + g * g - s * s) / (2 * g);
}

} // namespace

WalkSums &WalkSums::operator+=(const WalkSums &other) {
  walks += other.walks;
  scatterings += other.scatterings;
  rays += other.rays;
  weight += other.weight;
  squares += other.squares;
  return *this;
}

double WalkSums::variance() const { return std::max(0.0, squares - weight * mean()) / (walks - 1); }

double WalkSums::standard_error() const { return std::sqrt(variance() / walks); }

PlainWalk::PlainWalk(const MeshData &mesh, const EmbreeOracle &oracle_)
    : oracle(oracle_), planes(mesh.triangle_count()) {
  for (float x : mesh.positions)
    step = std::max(step, 1e-6f * std::fabs(x));
  for (size_t t = 0; t < planes.size(); ++t) {
    const float *p[3];
    for (size_t i = 0; i < 3; ++i)
      p[i] = &mesh.positions[3 * size_t(mesh.indices[3 * t + i])];
    double n[3];
    for (int k = 0; k < 3; ++k) {
      int l = (k + 1) % 3, m = (k + 2) % 3;
      n[k] =
          double(p[2][l] - p[0][l]) * double(p[1][m] - p[0][m]) - double(p[1][l] - p[0][l]) * double(p[2][m] - p[0][m]);
    }
    double length = std::sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]), offset = 0;
    for (int k = 0; k < 3; ++k) {
      planes[t].normal[k] = float(n[k] / length);
      offset += n[k] / length * double(p[0][k]);
    }
    planes[t].offset = float(offset);
  }
}

// Inwards from a triangle, by the cosine law.
void PlainWalk::begin(const TynWalkEntry &entry, TynRay &ray, Random &random) const {
  const Plane &plane = planes[entry.triangle];
  std::copy(plane.normal, plane.normal + 3, ray.direction);
  std::copy(entry.position, entry.position + 3, ray.origin);
  move(ray.origin, plane.normal, step);
  float cosine = std::sqrt(random.uniform());
  deflect(ray.direction, cosine, random.uniform());
}

// At the boundary: false if the walk leaves, else the ray goes on from there, mirrored.
bool PlainWalk::stays_inside(const PlainMedium &medium, const TynHit &hit, TynRay &ray, Random &random) const {
  const Plane &plane = planes[hit.triangle];
  float cosine = -dot(ray.direction, plane.normal);
  // one that rounding had put outside, and that comes back, has left
  if (medium.ior == 1 || cosine <= 0 || random.uniform() >= fresnel(cosine, 1 / medium.ior))
    return false;
  move(ray.origin, ray.direction, hit.t);
  move(ray.origin, plane.normal, step - (dot(ray.origin, plane.normal) - plane.offset));
  move(ray.direction, plane.normal, 2 * cosine);
  return true;
}

void PlainWalk::walk(const PlainMedium &medium, const TynWalkEntry &entry, Random random, WalkSums &sums) const {
  const float threshold = tyn_walk_options().roulette_threshold;
  TynRay ray{};
  begin(entry, ray, random);
  ++sums.walks;
  for (float weight = 1;;) {
    ray.t_max = -std::log(random.uniform()) / medium.sigma_t;
    const TynHit hit = oracle.intersect(ray);
    ++sums.rays;
    if (hit.mesh != TYN_NONE) {
      if (stays_inside(medium, hit, ray, random))
        continue;
      sums.weight += double(weight);
      sums.squares += double(weight) * double(weight);
      return;
    }
    move(ray.origin, ray.direction, ray.t_max);
    ++sums.scatterings;
    weight *= medium.albedo;
    if (weight < threshold) {
      if (random.uniform() * threshold >= weight)
        return;
      weight = threshold;
    }
    float cosine = henyey_greenstein(medium.g, random.uniform());
    deflect(ray.direction, cosine, random.uniform());
  }
}

WalkSums PlainWalk::run(const PlainMedium &medium, const std::vector<TynWalkEntry> &entries, uint64_t first_path,
                        unsigned threads) const {
  constexpr size_t SHARE = 16; // walks a thread takes at a time
  std::atomic<size_t> next{0};
  std::vector<WalkSums> sums(threads);
  std::vector<std::thread> running;
  for (WalkSums &mine : sums)
    running.emplace_back([&] {
      WalkSums own;
      for (size_t first; (first = SHARE * next++) < entries.size();)
        for (size_t i = first; i < std::min(entries.size(), first + SHARE); ++i)
          walk(medium, entries[i], Random(first_path + i), own);
      mine = own;
    });
  for (std::thread &thread : running)
    thread.join();
  WalkSums all;
  for (const WalkSums &one : sums)
    all += one;
  return all;
}

} // namespace tyn_test
