// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include "media/phase.hpp"
#include "media/fresnel.hpp"
#include "slab/batches.hpp"
#include "slab/tallies.hpp"

namespace tyn {

namespace {

constexpr uint64_t tally_memory = uint64_t(32) << 20; // bytes of the tallies of all batches of a launch
constexpr uint64_t most_batches_at_once = 256;
// Below this 1 - albedo is too coarse as a float next to 1: events then absorb walks as a whole, with a probability.
constexpr double analog_absorption = 1e-4;
constexpr uint32_t gpu_slice = 4; // photons a work-item; its hardware keeps itself full with many of them

template <class T>
Buffer upload(TynContext &context, const std::vector<T> &data) {
  if (data.empty())
    return Buffer(context, 0);
  return Buffer(context, data.size() * sizeof(T), CL_MEM_READ_ONLY | CL_MEM_COPY_HOST_PTR, data.data());
}

bool one_index(const Slab &slab) {
  for (const SlabLayer &layer : slab.layers)
    if (layer.ior != slab.ior_above)
      return false;
  return std::isinf(slab.layers.back().thickness) || slab.ior_below == slab.ior_above;
}

TynSlabLayerRecord layer_record(const SlabLayer &layer, size_t channel, const TynPhaseRecord &phase, double top) {
  TynSlabLayerRecord record{};
  const double sigma_t = layer.sigma_a[channel] + layer.sigma_s[channel];
  record.mean_free_path = sigma_t > 0 ? float(std::min(1 / sigma_t, 1e28)) : 1e30f;
  const double absorption = sigma_t > 0 ? layer.sigma_a[channel] / sigma_t : 0;
  record.absorption = absorption < analog_absorption ? float(absorption) : 0.0f;
  record.albedo = absorption < analog_absorption ? 1.0f : float(layer.sigma_s[channel] / sigma_t);
  record.general = phase.kind != TYN_PHASE_HENYEY_GREENSTEIN;
  record.g = record.general ? 0.0f : phase.g;
  record.top = float(top);
  record.thickness = float(layer.thickness);
  record.ior = float(layer.ior);
  return record;
}

uint32_t flags_of(const Slab &slab, const TynSlabOptions &options, const std::vector<TynPhaseRecord> &phases) {
  uint32_t flags = TYN_SLAB_ISOTROPIC;
  for (const TynPhaseRecord &phase : phases) {
    if (phase.kind != TYN_PHASE_HENYEY_GREENSTEIN)
      flags |= TYN_SLAB_GENERAL;
    if (phase.kind != TYN_PHASE_HENYEY_GREENSTEIN || phase.g != 0)
      flags &= ~TYN_SLAB_ISOTROPIC;
  }
  if (options.radial_bins)
    flags |= TYN_SLAB_LATERAL;
  if (options.path_bins || options.sweep_count)
    flags |= TYN_SLAB_LENGTH;
  if (options.incidence == TYN_INCIDENCE_DIFFUSE)
    flags |= TYN_SLAB_DIFFUSE;
  if (one_index(slab))
    flags |= TYN_SLAB_MATCHED;
  if (options.radial_bins || options.angular_bins || options.order_bins || options.path_bins || options.sweep_count)
    flags |= TYN_SLAB_BINS;
  for (const SlabLayer &layer : slab.layers)
    for (uint32_t c = 0; c < slab.channels; ++c) {
      if (layer.sigma_a[c] + layer.sigma_s[c] == 0)
        flags |= TYN_SLAB_CLEAR;
      else if (layer.sigma_a[c] > 0 && layer.sigma_a[c] < analog_absorption * (layer.sigma_a[c] + layer.sigma_s[c]))
        flags |= TYN_SLAB_ANALOG;
    }
  return flags;
}

} // namespace

BatchEngine::BatchEngine(TynContext &context_, const Slab &slab, const TynSlabOptions &options,
                         const EscapeGrid *escapes)
    : context(context_) {
  base.seed[0] = uint32_t(options.seed);
  base.seed[1] = uint32_t(options.seed >> 32);
  base.layer_count = uint32_t(slab.layers.size());
  base.max_order = options.max_order;
  base.roulette_threshold = float(options.roulette_threshold);
  base.ior_above = float(slab.ior_above);
  base.ior_below = float(slab.ior_below);
  // where nothing is resolved over the radius it does not matter where light arrives
  base.beam = options.radial_bins ? options.beam : uint32_t(TYN_BEAM_PENCIL);
  base.beam_radius = float(options.beam_radius);
  lay_out_tallies(options, slab.channels, base);
  set_incidence(slab, options);
  PhaseTables phase_tables;
  std::vector<TynPhaseRecord> records;
  for (const SlabLayer &layer : slab.layers)
    records.push_back(phase_tables.add(layer.phase));
  base.flags = flags_of(slab, options, records);
  if (escapes)
    add_escapes(*escapes);
  phases = upload(context, records);
  tables = upload(context, phase_tables.data);
  for (uint32_t c = 0; c < slab.channels; ++c) {
    std::vector<TynSlabLayerRecord> list;
    double top = 0;
    for (size_t i = 0; i < slab.layers.size(); ++i) {
      list.push_back(layer_record(slab.layers[i], c, records[i], top));
      top += slab.layers[i].thickness;
    }
    layers.push_back(upload(context, list));
  }
  upload_sweep(slab, options);

  allocate_tallies();
}

void BatchEngine::add_escapes(const EscapeGrid &escapes) {
  base.flags |= TYN_SLAB_LATERAL | TYN_SLAB_ESCAPES;
  base.escapes = base.tally_count;
  base.escape_first_radius = escapes.first_radius;
  base.escape_radii = escapes.radii;
  base.tally_count += uint32_t(escapes.cells());
}

// Room for some batches at once: on a CPU a batch is what a work-item does, so that there have to be a few for each core.
void BatchEngine::allocate_tallies() {
  const uint64_t bytes = uint64_t(base.tally_count) * sizeof(uint64_t);
  const uint64_t room = std::min({tally_memory, context.memory_available() / 2, context.largest_buffer()});
  batches = uint32_t(std::min<uint64_t>(room / bytes, most_batches_at_once));
  if (batches == 0)
    fail(TYN_ERROR_OUT_OF_MEMORY, "the bins asked for need %llu bytes of device memory; %llu are left",
         (unsigned long long)bytes, (unsigned long long)context.memory_available());
  tallies = Buffer(context, batches * bytes);
  host_tallies.resize(size_t(batches) * base.tally_count);
}

// Light enters along the direction that the first interface refracts it into.
void BatchEngine::set_incidence(const Slab &slab, const TynSlabOptions &options) {
  const double eta = slab.layers[0].ior / slab.ior_above;
  const double cosine = std::cos(options.angle), sine = std::sin(options.angle);
  if (options.incidence == TYN_INCIDENCE_COLLIMATED)
    first_reflection = fresnel_reflectance(cosine, eta);
  base.start[0] = float(sine / eta);
  base.start[1] = 0;
  base.start[2] = float(std::sqrt(std::max(0.0, 1 - sine * sine / (eta * eta))));
  base.start[3] = float(1 - first_reflection);
}

// What the weight of a walk in the slab becomes in a row's medium: with n events and the length s in a layer,
// (sigma_s' / sigma_s)^n exp(-(sigma_t' - sigma_t) s).
void BatchEngine::upload_sweep(const Slab &slab, const TynSlabOptions &options) {
  for (uint32_t c = 0; c < slab.channels; ++c) {
    std::vector<float> rows;
    for (uint32_t row = 0; row < options.sweep_count; ++row)
      for (size_t i = 0; i < slab.layers.size(); ++i) {
        const SlabLayer &layer = slab.layers[i];
        const double sigma_a = options.sweep_sigma_a[row * slab.layers.size() + i];
        const double sigma_s = options.sweep_sigma_s[row * slab.layers.size() + i];
        const double ratio = layer.sigma_s[c] > 0 ? sigma_s / layer.sigma_s[c] : 1;
        rows.push_back(float(std::max(std::log(std::min(ratio, 1.0)), -1e30))); // no infinity times zero events
        rows.push_back(float(std::max(0.0, sigma_a + sigma_s - layer.sigma_a[c] - layer.sigma_s[c])));
      }
    sweeps.push_back(upload(context, rows));
  }
}

void BatchEngine::prepare() {
  TynSlabParameters nothing = base;
  nothing.batch = nothing.slice = nothing.batch_items = 1;
  launch(0, nothing, 1);
  context.finish();
}

const int64_t *BatchEngine::walk(size_t channel, uint64_t first, uint32_t count, uint32_t batch) {
  TynSlabParameters parameters = base;
  parameters.first_photon[0] = uint32_t(first);
  parameters.first_photon[1] = uint32_t(first >> 32);
  parameters.count = count;
  parameters.batch = batch;
  // one lane wide, tallies are atomic and a batch may be shared: on a GPU by many, on a CPU by a few
  parameters.slice = batch;
  if (context.lanes() == 1)
    parameters.slice = context.is_gpu() ? std::min(batch, gpu_slice) : std::max(1u, batch / 4);
  parameters.batch_items = (batch + parameters.slice - 1) / parameters.slice;
  const uint32_t used = (count + batch - 1) / batch;
  launch(channel, parameters, used);
  context.read(tallies, host_tallies.data(), size_t(used) * base.tally_count * sizeof(int64_t));
  return host_tallies.data();
}

void BatchEngine::launch(size_t channel, const TynSlabParameters &parameters, uint32_t used) {
  const uint32_t total = used * base.tally_count;
  context.launch("slab", "slab_clear_tallies", total, 64, tallies, total);
  context.launch("slab", "slab_walk", size_t(used) * parameters.batch_items, context.is_gpu() ? 64 : 1, layers[channel],
                 phases, tables, sweeps[channel], tallies, parameters);
}

} // namespace tyn
