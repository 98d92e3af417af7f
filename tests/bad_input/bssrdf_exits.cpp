// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
// What tyn_bssrdf_sample_exits refuses: a status, a message that says what is wrong, and nothing is written.
#include <cmath>
#include <functional>

#include <gtest/gtest.h>

#include "common/bssrdf_exits.hpp"

namespace {

using namespace tyn_test;

class BadExits : public testing::Test {
protected:
  SceneHandle scene = bare_scene(shared_context(), quad(10));
  BssrdfModel model = gaussian_model();
  TynBssrdfEntry entries[2] = {bssrdf_entry({0, 0, 0}, {0, 1, 0}), bssrdf_entry({0, 0, 0}, {0, 1, 0})};
  TynBssrdfExit exits[2] = {};
  float weights[2] = {-1, -1};

  TynStatus draw(TynScene *from, size_t count = 2) {
    return tyn_bssrdf_sample_exits(model.get(), from, 0, 0, entries, count, exits, weights);
  }
};

TEST_F(BadExits, EntriesAreNamedWithFieldAndValue) {
  struct Case {
    std::function<void(TynBssrdfEntry &)> spoil;
    const char *message;
  };
  const Case cases[] = {
      {[](TynBssrdfEntry &e) { e.position[1] = NAN; }, "entry 1: position[1] is nan"},
      {[](TynBssrdfEntry &e) { e.position[0] = INFINITY; }, "entry 1: position[0] is inf"},
      {[](TynBssrdfEntry &e) { e.normal[1] = 0.9f; }, "entry 1: normal is (0, 0.9, 0)"},
      {[](TynBssrdfEntry &e) { e.normal[2] = NAN; }, "entry 1: normal[2] is nan"},
      {[](TynBssrdfEntry &e) { e.mesh = 1; }, "entry 1: mesh is 1"},
      {[](TynBssrdfEntry &e) { e.reserved = 7; }, "entry 1: reserved fields are 7, 0 and 0"},
      {[](TynBssrdfEntry &e) { e.reserved2[1] = 3; }, "0 and 3; they must be 0"},
  };
  for (const Case &c : cases) {
    entries[1] = entries[0];
    c.spoil(entries[1]);
    EXPECT_EQ(draw(scene.get()), TYN_ERROR_INVALID_ARGUMENT);
    const std::string message = tyn_context_message(shared_context());
    EXPECT_NE(message.find(c.message), std::string::npos) << message;
    EXPECT_EQ(weights[0], -1);
  }
}

TEST_F(BadExits, ObjectsMustBeThereAndBelongTogether) {
  EXPECT_EQ(tyn_bssrdf_sample_exits(nullptr, scene.get(), 0, 0, entries, 2, exits, weights),
            TYN_ERROR_INVALID_ARGUMENT);
  EXPECT_EQ(draw(nullptr), TYN_ERROR_INVALID_ARGUMENT);
  EXPECT_EQ(tyn_bssrdf_sample_exits(model.get(), scene.get(), 0, 0, nullptr, 2, exits, weights),
            TYN_ERROR_INVALID_ARGUMENT);
  EXPECT_EQ(tyn_bssrdf_sample_exits(model.get(), scene.get(), 0, 0, entries, 2, nullptr, weights),
            TYN_ERROR_INVALID_ARGUMENT);
  EXPECT_EQ(tyn_bssrdf_sample_exits(model.get(), scene.get(), 0, 0, entries, 2, exits, nullptr), TYN_OK);
  EXPECT_EQ(tyn_bssrdf_sample_exits(model.get(), scene.get(), 0, 0, nullptr, 0, nullptr, nullptr), TYN_OK);
  const ContextHandle other = make_context();
  const SceneHandle elsewhere = bare_scene(other.get(), quad(10));
  EXPECT_EQ(draw(elsewhere.get()), TYN_ERROR_INVALID_ARGUMENT);
  TynScene *open = nullptr;
  ASSERT_EQ(tyn_scene_create(shared_context(), nullptr, &open), TYN_OK);
  EXPECT_EQ(draw(open), TYN_ERROR_INVALID_OPERATION);
  tyn_scene_release(open);
}

} // namespace
