// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
// Walks in a flat box are walks in a slab: the same medium in tyn_slab_simulate, which knows no mesh, gives the same totals and
// the same light at every distance from where it entered. The box is 64 wide and 1 thick; what would pass its rim is below
// e^-60 of what enters.
#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "common/slab_run.hpp"
#include "common/statistics.hpp"
#include "common/walk_scene.hpp"
#include "core/pi.hpp"

namespace {

using namespace tyn_test;

struct Beam {
  const char *name;
  float g, ior;
  double angle; // of arrival, from the normal
};

constexpr size_t batch = 250000, batches = 4;
constexpr uint64_t photons = 8000000;
constexpr size_t rings = 16;
constexpr double radial_max = 2;

// Three colours whose albedos are 2/3, 0.95 and 0.996, with the same reduced scattering for every g.
TynMedium box_medium(const Beam &beam) {
  const float s = 1 / (1 - beam.g);
  return rgb_medium({1, 0.2f, 0.02f}, {2 * s, 3.8f * s, 5 * s}, beam.g, beam.ior);
}

struct Side {
  Mean total[3], unscattered[3];
  std::vector<Mean> ring[3]; // of scattered light
};

// What leaves a side. Every walk counts everywhere, with 0 where it does not leave.
struct WalkedBox {
  Side sides[2]; // top, bottom
  uint64_t leaked = 0, lost = 0;
};

void add(WalkedBox &box, const TynWalkExit &exit, double reflected) {
  const bool escaped = exit.status == TYN_WALK_ESCAPED;
  const double r = std::hypot(double(exit.position[0]), double(exit.position[2]));
  const size_t ring = r < radial_max ? size_t(r / radial_max * rings) : rings;
  for (size_t s = 0; s < 2; ++s) {
    const bool leaves = escaped && (exit.position[1] > 0) == (s == 0);
    for (int c = 0; c < 3; ++c) {
      Side &side = box.sides[s];
      const double weight = leaves ? double(exit.weight[c]) : 0, surface = s == 0 ? reflected : 0;
      side.total[c].add(weight + surface);
      side.unscattered[c].add((exit.scatterings == 0 ? weight : 0) + surface);
      for (size_t i = 0; i < rings; ++i)
        side.ring[c][i].add(i == ring && exit.scatterings > 0 ? weight : 0);
    }
  }
}

// Light from above at the middle of the top, which lies on the diagonal between its two triangles.
WalkedBox walk_box(const Beam &beam) {
  const MeshData mesh = box(64, 1, 64);
  SceneHandle scene = make_scene(shared_context(), mesh, box_medium(beam));
  TynWalkEntry entry = plain_entry(TYN_ENTRY_REFRACT);
  entry.position[1] = 0.5f;
  entry.direction[0] = float(std::sin(beam.angle));
  entry.direction[1] = -float(std::cos(beam.angle));
  entry.direction[2] = 0;
  entry.triangle = 6;
  const std::vector<TynWalkEntry> entries(batch, entry);
  WalkedBox result;
  for (Side &side : result.sides)
    for (auto &ring : side.ring)
      ring.resize(rings);
  for (size_t i = 0; i < batches; ++i) {
    TynWalkOptions options = tyn_walk_options();
    options.seed = 50;
    options.first_path = i * batch;
    const Walked walked = walk(scene.get(), entries, options);
    // by the smooth boundary: the same for every walk
    const double reflected = walked.ledger.reflected[0] / double(batch);
    for (const TynWalkExit &exit : walked.exits)
      add(result, exit, reflected);
    result.leaked += walked.ledger.leaked_walks;
    result.lost += walked.ledger.lost_walks;
  }
  return result;
}

SlabOutcome simulate_slab(const Beam &beam) {
  const TynMedium medium = box_medium(beam);
  const std::vector<double> sigma_a(medium.sigma_a, medium.sigma_a + 3), sigma_s(medium.sigma_s, medium.sigma_s + 3);
  TynSlabLayer layer = tyn_slab_layer();
  layer.sigma_a = sigma_a.data();
  layer.sigma_s = sigma_s.data();
  layer.g = double(beam.g);
  layer.ior = double(beam.ior);
  layer.thickness = 1;
  TynSlab slab = tyn_slab();
  slab.channel_count = 3;
  slab.layer_count = 1;
  slab.layers = &layer;
  TynSlabOptions options = slab_options(photons, 51);
  options.angle = beam.angle;
  options.radial_bins = rings;
  options.radial_max = radial_max;
  return simulate(slab, options);
}

// In standard errors.
double off(const Mean &mean, double expected, double error) {
  const double both = std::hypot(mean.standard_error(), error);
  return both > 0 ? (mean.mean() - expected) / both : 0;
}

class WalkSlab : public testing::TestWithParam<Beam> {};

// N = 1e6 walks and 3 x 8e6 photons a beam. Totals within 4 standard errors: 3 colours x 2 sides x 2 totals x 5 beams, false
// alarms 4e-3 in all. Rings within 5: 3 x 2 x 16 x 5 of them, 3e-4. All rings of a colour and side together by chi-square at
// 1e-5: 30 of them, 3e-4. What comes out in the rings is not symmetric, but far from few.
TEST_P(WalkSlab, AFlatBoxGivesTheSlabsTotalsAndRings) {
  const WalkedBox box = walk_box(GetParam());
  const SlabOutcome slab = simulate_slab(GetParam());
  EXPECT_EQ(box.leaked, 0u);
  EXPECT_EQ(box.lost, 0u);
  double worst_total = 0, worst_ring = 0, worst_tail = 1, largest_error = 0;
  for (size_t c = 0; c < 3; ++c) {
    const TynSlabTotals &totals = slab.totals[c];
    const TynEstimate total[2] = {totals.reflectance, totals.transmittance};
    const TynEstimate unscattered[2] = {totals.specular_reflectance, totals.direct_transmittance};
    for (uint32_t s = 0; s < 2; ++s) {
      SCOPED_TRACE("channel " + std::to_string(c) + (s == 0 ? " reflected" : " transmitted"));
      const Side &side = box.sides[s];
      const double z = off(side.total[c], total[s].value, total[s].standard_error);
      // where the forward media let through a handful of walks at most, their errors mean nothing
      const bool enough = unscattered[s].value > 1e-3;
      const double direct = enough ? off(side.unscattered[c], unscattered[s].value, unscattered[s].standard_error) : 0;
      EXPECT_LT(std::abs(z), four_sigma) << side.total[c].mean() << " is not " << total[s].value;
      EXPECT_LT(std::abs(direct), four_sigma) << side.unscattered[c].mean() << " is not " << unscattered[s].value;
      worst_total = std::max({worst_total, std::abs(z), std::abs(direct)});
      largest_error = std::max(largest_error, side.total[c].standard_error() / side.total[c].mean());
      double squares = 0;
      for (size_t i = 0; i < rings; ++i) {
        const double width = radial_max / rings, area = tyn::pi * width * width * double(2 * i + 1);
        const uint32_t quantity = s == 0 ? TYN_SLAB_RADIAL_REFLECTANCE : TYN_SLAB_RADIAL_TRANSMITTANCE;
        const double ring = off(side.ring[c][i], slab.value(quantity, c)[i] * area, slab.error(quantity, c)[i] * area);
        EXPECT_LT(std::abs(ring), 5) << "ring " << i;
        worst_ring = std::max(worst_ring, std::abs(ring));
        squares += ring * ring;
      }
      const double tail = chi_square_tail(squares, rings);
      EXPECT_GT(tail, 1e-5);
      worst_tail = std::min(worst_tail, tail);
    }
  }
  EXPECT_LT(largest_error, 0.01) << "too few walks to say anything";
  printf("totals within %.1f, rings within %.1f standard errors, least chi-square tail %.2g\n", worst_total, worst_ring,
         worst_tail);
}

INSTANTIATE_TEST_SUITE_P(Of, WalkSlab,
                         testing::Values(Beam{"MatchedIsotropic", 0, 1, 0}, Beam{"MatchedForward", 0.8f, 1, 0},
                                         Beam{"DielectricIsotropic", 0, 1.4f, 0},
                                         Beam{"DielectricForward", 0.8f, 1.4f, 0},
                                         Beam{"DielectricOblique", 0.8f, 1.4f, 1}),
                         [](const auto &parameter) { return std::string(parameter.param.name); });

} // namespace
