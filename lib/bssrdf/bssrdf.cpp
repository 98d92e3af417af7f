// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
// Profiles as kernels read them, and the life of a TynBssrdf.
#include "bssrdf/bssrdf.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "bssrdf/diffusion.hpp"
#include "core/argument.hpp"
#include "core/pi.hpp"

namespace tyn {
namespace {

void append(std::vector<float> &floats, const std::vector<double> &values) {
  for (double value : values)
    floats.push_back(float(value));
}

// Of the Gaussians below each.
std::vector<double> gaussian_chances(const Profile &profile) {
  std::vector<double> chances(1, 0.0);
  for (uint32_t i = 0; i + 1 < profile.count; i++) // a / b is twice the weight over pi
    chances.push_back(chances.back() + pi * profile.terms[2 * i] / profile.terms[2 * i + 1] / profile.albedo);
  return chances;
}

// Of a lobe of radiance whose exitance is 1: light that is diffuse inside, as far as the boundary lets it out.
double lobe(double ior) { return 1 / (pi * (1 - 2 * fresnel_moments(1 / ior).c1)); }

TynProfileRecord record_of(const Profile &profile, double all_albedos, std::vector<float> &terms) {
  TynProfileRecord record{};
  record.kind = profile.kind;
  record.first = uint32_t(terms.size());
  record.count = profile.count;
  record.length = float(profile.length);
  record.per_length = float(1 / profile.length);
  record.per_area = float(1 / (profile.length * profile.length));
  record.falloff = float(profile.falloff);
  record.flux = float(profile.flux);
  record.fluence = float(profile.fluence);
  record.albedo = float(profile.albedo);
  record.chance = all_albedos > 0 ? float(profile.albedo / all_albedos) : 0;
  append(terms, profile.terms);
  std::vector<double> chances;
  if (profile.albedo > 0 && profile.kind == TYN_PROFILE_GAUSSIANS)
    chances = gaussian_chances(profile);
  else if (profile.albedo > 0 && profile.kind != TYN_PROFILE_EXPONENTIALS)
    chances = sampler_chances(profile);
  record.reach = float(profile.length * profile_reach(profile, chances, TYN_BSSRDF_TAIL));
  record.chances = uint32_t(terms.size());
  append(terms, chances);
  record.directions = profile.directions;
  record.more = uint32_t(terms.size());
  append(terms, profile.more);
  return record;
}

} // namespace
} // namespace tyn

TynBssrdf::TynBssrdf(TynContext &context_, tyn::PreparedBssrdf prepared)
    : context(context_), profiles(std::move(prepared.profiles)), transmitted(prepared.transmitted) {
  double all_albedos = 0;
  for (const tyn::Profile &profile : profiles)
    all_albedos += profile.albedo;
  const float lobe = float(tyn::lobe(prepared.exit_ior));
  std::vector<TynProfileRecord> host_records;
  std::vector<float> host_terms;
  for (const tyn::Profile &profile : profiles) {
    TynProfileRecord record = tyn::record_of(profile, all_albedos, host_terms);
    record.ior = float(prepared.ior);
    record.exit_ior = float(prepared.exit_ior);
    record.lobe = lobe;
    host_records.push_back(record);
  }
  records = tyn::Buffer(context, host_records.size() * sizeof(TynProfileRecord), CL_MEM_READ_ONLY);
  context.write(records, host_records.data(), records.size());
  for (const TynProfileRecord &record : host_records)
    reach = std::max(reach, record.reach);
  terms = tyn::Buffer(context, host_terms.size() * sizeof(float), CL_MEM_READ_ONLY);
  context.write(terms, host_terms.data(), terms.size());
  context.retain();
}

void TynBssrdf::retain() { references.fetch_add(1, std::memory_order_relaxed); }

void TynBssrdf::release() {
  if (references.fetch_sub(1, std::memory_order_acq_rel) != 1)
    return;
  TynContext &owner = context;
  delete this;
  owner.release();
}

TynStatus tyn_bssrdf_create(TynContext *context, const TynSlab *slab, const TynBssrdfOptions *options,
                            TynBssrdf **bssrdf) {
  if (bssrdf)
    *bssrdf = nullptr;
  if (!context)
    return TYN_ERROR_INVALID_ARGUMENT;
  return tyn::guarded(context, [&] {
    tyn::require_pointer("bssrdf", bssrdf);
    *bssrdf = new TynBssrdf(*context, tyn::prepare_bssrdf(*context, slab, options));
  });
}

void tyn_bssrdf_retain(TynBssrdf *bssrdf) {
  if (bssrdf)
    bssrdf->retain();
}

void tyn_bssrdf_release(TynBssrdf *bssrdf) {
  if (bssrdf)
    bssrdf->release();
}

TynStatus tyn_bssrdf_albedo(const TynBssrdf *bssrdf, double *albedo, size_t count) {
  if (!bssrdf)
    return TYN_ERROR_INVALID_ARGUMENT;
  return tyn::guarded(&bssrdf->context, [&] {
    tyn::require_pointer("albedo", albedo);
    if (count != bssrdf->channels())
      tyn::fail(TYN_ERROR_INVALID_ARGUMENT, "count is %zu; there are %u channels", count, bssrdf->channels());
    for (size_t c = 0; c < count; c++)
      albedo[c] = bssrdf->profiles[c].albedo;
  });
}
