// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
// Long calls: batches that fit the memory limit, progress, cancelling.
#include <cstring>
#include <string>

#include <gtest/gtest.h>

#include "common/walk_scene.hpp"
#include "core/context.hpp"
#include "kernels/shared.h"

namespace {

using namespace tyn_test;

// Counts reports and cancels at one of them.
struct Watcher {
  int reports = 0;
  int cancel_at = -1;
  double last = -1;
  bool ordered = true;

  static int32_t report(void *user, double fraction) {
    Watcher &watcher = *static_cast<Watcher *>(user);
    watcher.ordered = watcher.ordered && fraction >= watcher.last && fraction >= 0 && fraction <= 1;
    watcher.last = fraction;
    return watcher.reports++ == watcher.cancel_at;
  }
};

TynWalkOptions watched(Watcher &watcher) {
  TynWalkOptions options = tyn_walk_options();
  options.progress = Watcher::report;
  options.user = &watcher;
  return options;
}

// A scene on a context that has room for about 100 walks at a time.
struct Cramped {
  ContextHandle context = make_context();
  SceneHandle scene = make_scene(context.get(), cube(), grey_medium(0.1f, 2));
  std::vector<TynWalkEntry> entries = surface_entries(cube(), 1000, 41);

  Cramped() {
    context->memory_limit =
        context->memory_used + 100 * (sizeof(TynWalkEntry) + sizeof(TynWalkExit) + sizeof(TynWalkTally));
  }
};

TEST(WalkBatches, ShrinkToFitTheMemoryLimitAndChangeNoBit) {
  Cramped cramped;
  SceneHandle roomy = make_scene(shared_context(), cube(), grey_medium(0.1f, 2));
  Walked expected = walk(roomy.get(), cramped.entries), result = walk(cramped.scene.get(), cramped.entries);
  EXPECT_EQ(std::memcmp(expected.exits.data(), result.exits.data(), expected.exits.size() * sizeof(TynWalkExit)), 0);
  EXPECT_EQ(std::memcmp(&expected.ledger, &result.ledger, sizeof expected.ledger), 0);
}

TEST(WalkBatches, WithoutRoomForOneWalkAreOutOfMemory) {
  Cramped cramped;
  cramped.context->memory_limit = cramped.context->memory_used + 10;
  TynWalkExit exit;
  EXPECT_EQ(tyn_walk(cramped.scene.get(), nullptr, cramped.entries.data(), 1, &exit, nullptr), TYN_ERROR_OUT_OF_MEMORY);
  EXPECT_NE(std::string(tyn_context_message(cramped.context.get())).find("memory"), std::string::npos);
}

TEST(WalkBatches, ReportProgressFromNothingToAll) {
  Cramped cramped;
  Watcher watcher;
  walk(cramped.scene.get(), cramped.entries, watched(watcher));
  EXPECT_GE(watcher.reports, 10);
  EXPECT_TRUE(watcher.ordered);
  EXPECT_EQ(watcher.last, 1.0);
}

TEST(WalkBatches, CancelledOnesKeepWhatIsDone) {
  Cramped cramped;
  Walked expected = walk(cramped.scene.get(), cramped.entries);
  for (int cancel_at : {0, 1, 5, 9}) {
    Watcher watcher;
    watcher.cancel_at = cancel_at;
    TynWalkOptions options = watched(watcher);
    std::vector<TynWalkExit> exits(cramped.entries.size());
    TynLedger ledger;
    ASSERT_EQ(tyn_walk(cramped.scene.get(), &options, cramped.entries.data(), exits.size(), exits.data(), &ledger),
              TYN_ERROR_CANCELLED);
    EXPECT_EQ(watcher.reports, cancel_at + 1);
    EXPECT_EQ(ledger.walks, uint64_t(100 * cancel_at));
    EXPECT_EQ(std::memcmp(expected.exits.data(), exits.data(), ledger.walks * sizeof(TynWalkExit)), 0);
    for (int c = 0; c < 3; ++c)
      EXPECT_NEAR(accounted(ledger, c), ledger.entered[c], 1e-3);
  }
  // and the scene still works
  Walked again = walk(cramped.scene.get(), cramped.entries);
  EXPECT_EQ(std::memcmp(expected.exits.data(), again.exits.data(), again.exits.size() * sizeof(TynWalkExit)), 0);
}

TEST(WalkBatches, OfNothingDoNothing) {
  SceneHandle scene = make_scene(shared_context(), cube(), grey_medium(0, 1));
  TynLedger ledger;
  std::memset(&ledger, 0xff, sizeof ledger);
  EXPECT_EQ(tyn_walk(scene.get(), nullptr, nullptr, 0, nullptr, &ledger), TYN_OK);
  EXPECT_EQ(ledger.walks, 0u);
  EXPECT_EQ(ledger.entered[0], 0);
}

} // namespace
