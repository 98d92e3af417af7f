// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
#include "render/ledger.hpp"

#include <cmath>
#include <vector>

namespace tyn {

void RenderLedger::add(TynContext &context, const Buffer &entries, const Buffer &exits, const Buffer &tallies,
                       uint32_t count, const Buffer &partial) {
  const size_t slices = (size_t(count) + TYN_LEDGER_SLICE - 1) / TYN_LEDGER_SLICE;
  context.launch("render_ledger", "ledger_sum", slices, 4, entries, exits, tallies, count, partial);
  std::vector<int64_t> values(slices * TYN_LEDGER_COUNT);
  context.read(partial, values.data(), values.size() * sizeof(int64_t));
  for (size_t i = 0; i < values.size(); i++)
    sums[i % TYN_LEDGER_COUNT] += values[i];
}

TynLedger RenderLedger::value() const {
  TynLedger ledger{};
  struct Row {
    double *to;
    uint32_t from;
  };
  const Row rows[] = {
      {ledger.entered, TYN_LEDGER_ENTERED}, {ledger.reflected, TYN_LEDGER_REFLECTED},
      {ledger.escaped, TYN_LEDGER_ESCAPED}, {ledger.absorbed, TYN_LEDGER_ABSORBED},
      {ledger.balance, TYN_LEDGER_BALANCE}, {ledger.capped, TYN_LEDGER_CAPPED},
      {ledger.leaked, TYN_LEDGER_LEAKED},   {ledger.lost, TYN_LEDGER_LOST},
  };
  for (const Row &row : rows)
    for (uint32_t c = 0; c < 3; c++)
      row.to[c] = std::ldexp(double(sums[row.from + c]), -32);

  uint64_t *const walks[] = {&ledger.escaped_walks, &ledger.absorbed_walks, &ledger.capped_walks,
                             &ledger.leaked_walks,  &ledger.lost_walks,     &ledger.reflected_walks};
  for (uint32_t status = 0; status < 6; status++) {
    *walks[status] = uint64_t(sums[TYN_LEDGER_WALKS + status]);
    ledger.walks += *walks[status];
  }
  ledger.scatterings = uint64_t(sums[TYN_LEDGER_SCATTERINGS]);
  return ledger;
}

} // namespace tyn
