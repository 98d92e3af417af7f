// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
// The device draws and evaluates as the host does: a kernel of the test's own on the sources of the walk.
#include <algorithm>
#include <cmath>
#include <cstring>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "common/phases.hpp"
#include "common/walk_scene.hpp"
#include "core/context.hpp"
#include "core/kernels.hpp"
#include "core/opencl_shim.hpp"

namespace {

using namespace tyn_test;

const char kernel_text[] = R"(
kernel void draw(global const TynPhaseRecord *phases, global const float *tables, global float *away, global float *value) {
  uint i = (uint)get_global_id(0);
  uint4 random = tyn_philox(tyn_uint4(i, 0u, 0u, TYN_DOMAIN_PHASE), tyn_uint2(3u, 0u));
  away[i] = tyn_phase_sample_away(phases[0], tables, random);
  value[i] = tyn_phase_value_away(phases[0], tables, away[i]);
}
)";

std::string source_of(const char *program) {
  for (size_t i = 0; i < tyn::kernel_source_count; i++)
    if (std::strcmp(tyn::kernel_sources[i].name, program) == 0)
      return tyn::kernel_sources[i].text;
  ADD_FAILURE() << "no program " << program;
  return "";
}

struct Drawn {
  std::vector<float> away, value;
};

Drawn draw_on_device(TynContext &context, const TynPhaseRecord &record, std::vector<float> tables, size_t count) {
  Drawn drawn{std::vector<float>(count), std::vector<float>(count)};
  tables.resize(std::max<size_t>(1, tables.size()));
  tyn::Buffer phases(context, sizeof record), data(context, tables.size() * sizeof(float)),
      away(context, count * sizeof(float)), value(context, count * sizeof(float));
  context.write(phases, &record, sizeof record);
  context.write(data, tables.data(), data.size());
  context.launch("draws", "draw", count, 64, phases, data, away, value);
  context.read(away, drawn.away.data(), away.size());
  context.read(value, drawn.value.data(), value.size());
  return drawn;
}

// Built-in functions may differ in the last bits, and so, once in a long while, may a refusal of Draine's: one draw in 1e4 may
// be another one.
TEST(PhaseDevice, DrawsWhatTheHostDraws) {
  const std::string text = source_of("walk") + kernel_text;
  TynContext &context = *shared_context();
  context.build(tyn::KernelSource{"draws", text.c_str(), text.size(), std::hash<std::string>()(text)});
  const size_t count = 64 * 1024;
  for (const PhaseCase &item : phase_cases()) {
    SCOPED_TRACE(item.name);
    const tyn::OwnedPhase phase = item.make();
    tyn::PhaseTables tables;
    const TynPhaseRecord record = tables.add(phase.get());
    const Drawn drawn = draw_on_device(context, record, tables.data, count);
    std::vector<double> cosines(count);
    ASSERT_EQ(tyn_phase_sample(&phase.get(), 3, 0, count, cosines.data()), TYN_OK);
    size_t other = 0;
    for (size_t i = 0; i < count; i++) {
      const double away = 1 - cosines[i];
      other += !(std::abs(drawn.away[i] - away) <= 2e-6 * away + 1e-6 * (record.kind == TYN_PHASE_RAYLEIGH));
      const float expected = tyn_kernel::tyn_phase_value_away(record, tables.data.data(), drawn.away[i]);
      ASSERT_NEAR(drawn.value[i], expected, 4e-6f * expected) << i;
    }
    EXPECT_LE(other, count / 10000);
  }
}

} // namespace
