// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
// The walk kernel under oclgrind with phase functions of every kind beside Henyey-Greenstein's: its reports fail the test (see
// tests/CMakeLists.txt).
#include <gtest/gtest.h>

#include "common/phases.hpp"
#include "common/walk_scene.hpp"

namespace {

using namespace tyn_test;

class CheckedWalkPhase : public testing::TestWithParam<uint32_t> {};

TEST_P(CheckedWalkPhase, OfEveryKind) {
  ContextHandle context = make_context(GetParam());
  const TynPhase two_lobes = two_lobe_phase(0.8, -0.3, 0.6), draine = draine_phase(0.3, 5);
  const tyn::OwnedPhase table = mie_phase(10, 1.33, 0, 20);
  TynPhase rayleigh = tyn_phase();
  rayleigh.kind = TYN_PHASE_RAYLEIGH;
  for (const TynPhase *phase : {&two_lobes, &draine, &table.get(), static_cast<const TynPhase *>(&rayleigh)}) {
    TynMedium medium = grey_medium(0.1f, 3);
    medium.phase = phase;
    SceneHandle scene = make_scene(context.get(), cube(), medium);
    const Walked walked = walk(scene.get(), surface_entries(cube(), 7, 5));
    EXPECT_EQ(walked.ledger.leaked_walks + walked.ledger.lost_walks, 0u) << phase->kind;
  }
}

INSTANTIATE_TEST_SUITE_P(WithLanes, CheckedWalkPhase, testing::Values(1u, 4u), testing::PrintToStringParamName());

} // namespace
