// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
// Phase functions and spheres out of range.
#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "core/status.hpp"
#include "media/phase.hpp"
#include "tyndall/tyndall.h"

namespace {

const double cosines[] = {-1, 0, 1}, values[] = {1, 2, 3};

TynPhase of_kind(uint32_t kind) {
  TynPhase phase = tyn_phase();
  phase.kind = kind;
  phase.cosines = cosines;
  phase.values = values;
  phase.count = 3;
  return phase;
}

std::string refusal(const TynPhase &phase) {
  try {
    tyn::validate(phase);
  } catch (const tyn::Failure &failure) {
    EXPECT_EQ(failure.status, TYN_ERROR_INVALID_ARGUMENT);
    return failure.what();
  }
  return "accepted";
}

// Every call refuses it, and writes nothing.
void expect_refused(const TynPhase *phase) {
  double out = 42;
  const double cosine = 0.5;
  EXPECT_EQ(tyn_phase_value(phase, &cosine, 1, &out), TYN_ERROR_INVALID_ARGUMENT);
  EXPECT_EQ(tyn_phase_pdf(phase, &cosine, 1, &out), TYN_ERROR_INVALID_ARGUMENT);
  EXPECT_EQ(tyn_phase_sample(phase, 1, 0, 1, &out), TYN_ERROR_INVALID_ARGUMENT);
  EXPECT_EQ(tyn_phase_moments(phase, 1, &out), TYN_ERROR_INVALID_ARGUMENT);
  EXPECT_EQ(tyn_phase_mean_cosine(phase, &out), TYN_ERROR_INVALID_ARGUMENT);
  EXPECT_EQ(out, 42.0);
}

struct Case {
  uint32_t kind;
  std::function<void(TynPhase &)> spoil;
  const char *message;
};

TEST(BadPhase, FieldsOutOfRange) {
  static const double from_zero[] = {0, 0.5, 1}, repeated[] = {-1, -1, 1}, unordered[] = {-1, NAN, 1};
  static const double negative[] = {1, -1, 1}, endless[] = {1, INFINITY, 1}, zeros[] = {0, 0, 0};
  static const double spike_cosines[] = {-1, 0, 1e-30, 1e-29, 1}, spike[] = {0, 0, 1, 0, 0};
  const std::vector<Case> cases = {
      {6, [](TynPhase &) {}, "kind is 6"},
      {TYN_PHASE_HENYEY_GREENSTEIN, [](TynPhase &p) { p.g = 1; }, "TynPhase::g is 1"},
      {TYN_PHASE_HENYEY_GREENSTEIN, [](TynPhase &p) { p.g = NAN; }, "TynPhase::g is nan"},
      {TYN_PHASE_TWO_LOBE, [](TynPhase &p) { p.g = -1; }, "TynPhase::g is -1"},
      {TYN_PHASE_TWO_LOBE, [](TynPhase &p) { p.g2 = 2; }, "TynPhase::g2 is 2"},
      {TYN_PHASE_TWO_LOBE, [](TynPhase &p) { p.weight = 1.5; }, "TynPhase::weight is 1.5"},
      {TYN_PHASE_TWO_LOBE, [](TynPhase &p) { p.weight = NAN; }, "TynPhase::weight is nan"},
      {TYN_PHASE_DRAINE, [](TynPhase &p) { p.g = INFINITY; }, "TynPhase::g is inf"},
      {TYN_PHASE_DRAINE, [](TynPhase &p) { p.alpha = -1; }, "TynPhase::alpha is -1"},
      {TYN_PHASE_DRAINE, [](TynPhase &p) { p.alpha = 2e6; }, "TynPhase::alpha is 2e+06"},
      {TYN_PHASE_TABULATED, [](TynPhase &p) { p.count = 1; }, "TynPhase::count is 1"},
      {TYN_PHASE_TABULATED, [](TynPhase &p) { p.count = 65537; }, "TynPhase::count is 65537"},
      {TYN_PHASE_TABULATED, [](TynPhase &p) { p.count = 2; }, "go from -1 to 0"},
      {TYN_PHASE_TABULATED, [](TynPhase &p) { p.cosines = nullptr; }, "TynPhase::cosines is NULL"},
      {TYN_PHASE_TABULATED, [](TynPhase &p) { p.values = nullptr; }, "TynPhase::values is NULL"},
      {TYN_PHASE_TABULATED, [](TynPhase &p) { p.cosines = from_zero; }, "go from 0 to 1"},
      {TYN_PHASE_TABULATED, [](TynPhase &p) { p.cosines = repeated; }, "cosines[1] is -1 after -1"},
      {TYN_PHASE_TABULATED, [](TynPhase &p) { p.cosines = unordered; }, "cosines[1] is nan"},
      {TYN_PHASE_TABULATED, [](TynPhase &p) { p.values = negative; }, "values[1] is -1"},
      {TYN_PHASE_TABULATED, [](TynPhase &p) { p.values = endless; }, "values[1] is inf"},
      {TYN_PHASE_TABULATED, [](TynPhase &p) { p.values = zeros; }, "all 0"},
      {TYN_PHASE_TABULATED, [](TynPhase &p) { p.count = 5, p.cosines = spike_cosines, p.values = spike; },
       "a peak of 1"},
  };
  for (const Case &bad : cases) {
    TynPhase phase = of_kind(bad.kind);
    bad.spoil(phase);
    EXPECT_NE(refusal(phase).find(bad.message), std::string::npos) << refusal(phase) << " lacks " << bad.message;
    expect_refused(&phase);
  }
  for (uint32_t kind = 0; kind < TYN_PHASE_KIND_COUNT; kind++)
    EXPECT_EQ(refusal(of_kind(kind)), "accepted");
}

TEST(BadPhase, WhatAKindDoesNotUseIsIgnored) {
  TynPhase phase = of_kind(TYN_PHASE_RAYLEIGH);
  phase.g = phase.g2 = phase.weight = phase.alpha = NAN;
  phase.cosines = phase.values = nullptr;
  phase.count = 1u << 31;
  EXPECT_EQ(refusal(phase), "accepted");
  EXPECT_EQ(tyn::OwnedPhase(phase).get().count, 0u);
}

TEST(BadPhase, ArgumentsOutOfRange) {
  const TynPhase phase = tyn_phase();
  double out = 42;
  for (double cosine : {-1.5, 1 + 1e-15, double(NAN)}) {
    EXPECT_EQ(tyn_phase_value(&phase, &cosine, 1, &out), TYN_ERROR_INVALID_ARGUMENT) << cosine;
    EXPECT_EQ(tyn_phase_pdf(&phase, &cosine, 1, &out), TYN_ERROR_INVALID_ARGUMENT) << cosine;
  }
  EXPECT_EQ(tyn_phase_value(&phase, nullptr, 1, &out), TYN_ERROR_INVALID_ARGUMENT);
  EXPECT_EQ(tyn_phase_value(&phase, cosines, 1, nullptr), TYN_ERROR_INVALID_ARGUMENT);
  EXPECT_EQ(tyn_phase_sample(&phase, 1, 0, 1, nullptr), TYN_ERROR_INVALID_ARGUMENT);
  EXPECT_EQ(tyn_phase_moments(&phase, 1, nullptr), TYN_ERROR_INVALID_ARGUMENT);
  EXPECT_EQ(tyn_phase_mean_cosine(&phase, nullptr), TYN_ERROR_INVALID_ARGUMENT);
  EXPECT_EQ(tyn_phase_value(&phase, nullptr, 0, nullptr), TYN_OK);
  EXPECT_EQ(tyn_phase_sample(&phase, 1, 0, 0, nullptr), TYN_OK);
  EXPECT_EQ(tyn_phase_moments(&phase, 0, nullptr), TYN_OK);
  EXPECT_EQ(out, 42.0);
  expect_refused(nullptr);
  TynPhase sized = tyn_phase();
  for (size_t size : {size_t(0), sizeof sized - 4, sizeof sized + 4}) {
    sized.size = size;
    expect_refused(&sized);
  }
}

// In a medium: the message says where, and the scene stays as it was.
TEST(BadPhase, InAMedium) {
  TynPhase phase = of_kind(TYN_PHASE_HENYEY_GREENSTEIN);
  phase.g = 1;
  TynMedium medium = tyn_medium();
  medium.phase = &phase;
  TynMediumDescription description;
  EXPECT_EQ(tyn_medium_describe(&medium, 1, 1, &description), TYN_ERROR_INVALID_ARGUMENT);
  TynContext *context = nullptr;
  ASSERT_EQ(tyn_context_create(nullptr, &context), TYN_OK);
  TynScene *scene = nullptr;
  ASSERT_EQ(tyn_scene_create(context, nullptr, &scene), TYN_OK);
  EXPECT_EQ(tyn_scene_add_medium(scene, &medium, nullptr), TYN_ERROR_INVALID_ARGUMENT);
  EXPECT_NE(std::string(tyn_context_message(context)).find("TynMedium::phase: TynPhase::g is 1"), std::string::npos)
      << tyn_context_message(context);
  phase.g = 0.5;
  phase.size = 8;
  EXPECT_EQ(tyn_scene_add_medium(scene, &medium, nullptr), TYN_ERROR_INVALID_ARGUMENT);
  TynSceneInfo info{};
  info.size = sizeof info;
  EXPECT_EQ(tyn_scene_info(scene, &info), TYN_OK);
  EXPECT_EQ(info.medium_count, 0u);
  tyn_scene_release(scene);
  tyn_context_release(context);
}

TEST(BadMie, ArgumentsOutOfRange) {
  const double water[] = {1.33, 0}, cosine = 0.5, beyond = 1.5;
  double out = 42;
  TynMie mie{};
  for (double x : {0.0, -1.0, 1.1e5, double(NAN), double(INFINITY)}) {
    EXPECT_EQ(tyn_mie(x, water, &mie, nullptr, 0, nullptr), TYN_ERROR_INVALID_ARGUMENT) << x;
    EXPECT_EQ(tyn_mie_cosines(x, 2, &out), TYN_ERROR_INVALID_ARGUMENT) << x;
  }
  const double bad[][2] = {{0, 1}, {-1, 0}, {1, -0.1}, {NAN, 0}, {1, NAN}, {INFINITY, 0}, {2000, 0}, {1e-4, 0}};
  for (const double(&index)[2] : bad) {
    EXPECT_EQ(tyn_mie(1, index, &mie, nullptr, 0, nullptr), TYN_ERROR_INVALID_ARGUMENT) << index[0];
    EXPECT_EQ(tyn_rayleigh_cross_section(1, 1, index, &out), TYN_ERROR_INVALID_ARGUMENT) << index[0];
  }
  EXPECT_EQ(tyn_mie(1, nullptr, &mie, nullptr, 0, nullptr), TYN_ERROR_INVALID_ARGUMENT);
  EXPECT_EQ(tyn_mie(1, water, nullptr, &beyond, 1, &out), TYN_ERROR_INVALID_ARGUMENT);
  EXPECT_EQ(tyn_mie(1, water, nullptr, nullptr, 1, &out), TYN_ERROR_INVALID_ARGUMENT);
  EXPECT_EQ(tyn_mie(1, water, nullptr, &cosine, 1, nullptr), TYN_ERROR_INVALID_ARGUMENT);
  EXPECT_EQ(tyn_mie(1, water, nullptr, nullptr, 0, nullptr), TYN_OK);
  for (size_t count : {size_t(0), size_t(1), size_t(65537)})
    EXPECT_EQ(tyn_mie_cosines(1, count, &out), TYN_ERROR_INVALID_ARGUMENT) << count;
  EXPECT_EQ(tyn_mie_cosines(1, 2, nullptr), TYN_ERROR_INVALID_ARGUMENT);
  EXPECT_EQ(tyn_rayleigh_cross_section(-1, 1, water, &out), TYN_ERROR_INVALID_ARGUMENT);
  EXPECT_EQ(tyn_rayleigh_cross_section(1, 0, water, &out), TYN_ERROR_INVALID_ARGUMENT);
  EXPECT_EQ(tyn_rayleigh_cross_section(1e200, 1, water, &out), TYN_ERROR_INVALID_ARGUMENT);
  EXPECT_EQ(tyn_rayleigh_cross_section(1, 1, water, nullptr), TYN_ERROR_INVALID_ARGUMENT);
  EXPECT_EQ(out, 42.0);
}

TEST(BadMie, DistributionsOutOfRange) {
  TynMieDistribution good = tyn_mie_distribution();
  good.median_radius = 1;
  good.geometric_deviation = 1.5;
  good.wavelength = 0.5;
  good.relative_index[0] = 1.33;
  const std::vector<std::function<void(TynMieDistribution &)>> spoilers = {
      [](TynMieDistribution &d) { d.size = 8; },
      [](TynMieDistribution &d) { d.median_radius = 0; },
      [](TynMieDistribution &d) { d.median_radius = NAN; },
      [](TynMieDistribution &d) { d.median_radius = 1e5; },
      [](TynMieDistribution &d) { d.median_radius = 1e5, d.geometric_deviation = 1; },
      [](TynMieDistribution &d) { d.geometric_deviation = 0.9; },
      [](TynMieDistribution &d) { d.geometric_deviation = 6; },
      [](TynMieDistribution &d) { d.geometric_deviation = NAN; },
      [](TynMieDistribution &d) { d.wavelength = 0; },
      [](TynMieDistribution &d) { d.wavelength = INFINITY; },
      [](TynMieDistribution &d) { d.relative_index[0] = 0; },
      [](TynMieDistribution &d) { d.relative_index[1] = -1; },
  };
  TynMieCrossSections sections{};
  EXPECT_EQ(tyn_mie_lognormal(&good, &sections, nullptr, 0, nullptr), TYN_OK);
  sections.extinction = 42;
  for (size_t i = 0; i < spoilers.size(); i++) {
    TynMieDistribution bad = good;
    spoilers[i](bad);
    EXPECT_EQ(tyn_mie_lognormal(&bad, &sections, nullptr, 0, nullptr), TYN_ERROR_INVALID_ARGUMENT) << i;
  }
  EXPECT_EQ(tyn_mie_lognormal(nullptr, &sections, nullptr, 0, nullptr), TYN_ERROR_INVALID_ARGUMENT);
  EXPECT_EQ(sections.extinction, 42.0);
}

} // namespace
