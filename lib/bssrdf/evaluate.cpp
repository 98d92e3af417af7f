// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
// The batch calls: on host pointers, batch by batch to the device and back, and on the caller's buffers.
#include <algorithm>
#include <vector>

#include "bssrdf/bssrdf.hpp"
#include "core/argument.hpp"
#include "core/batch.hpp"
#include "core/buffer_argument.hpp"
#include "tyndall/tyndall_cl.h"

namespace tyn {
namespace {

constexpr size_t MOST = size_t(1) << 20; // values in flight

void require_radii(const float *radii, size_t count) {
  require_pointer("radii", radii);
  for (size_t i = 0; i < count; i++)
    if (!(radii[i] > 0 && std::isfinite(radii[i])))
      fail(TYN_ERROR_INVALID_ARGUMENT, "radii[%zu] is %g; it must be finite and > 0", i, double(radii[i]));
}

// Without the names that a message would want, which take longer than the paths themselves.
bool is_path(const TynBssrdfPath &path) {
  auto finite = [](const float(&v)[3]) { return std::isfinite(v[0]) && std::isfinite(v[1]) && std::isfinite(v[2]); };
  auto unit = [](const float(&v)[3]) {
    const double square = double(v[0]) * double(v[0]) + double(v[1]) * double(v[1]) + double(v[2]) * double(v[2]);
    return std::abs(std::sqrt(square) - 1) <= 1e-3;
  };
  return finite(path.entry_position) && unit(path.entry_normal) && unit(path.entry_direction) &&
         finite(path.exit_position) && unit(path.exit_normal) && unit(path.exit_direction);
}

void require_path(const TynBssrdfPath &path) {
  require_each(require_finite, "entry_position", path.entry_position);
  require_unit("entry_normal", path.entry_normal);
  require_unit("entry_direction", path.entry_direction);
  require_each(require_finite, "exit_position", path.exit_position);
  require_unit("exit_normal", path.exit_normal);
  require_unit("exit_direction", path.exit_direction);
}

void require_paths(const TynBssrdfPath *paths, size_t count) {
  require_pointer("paths", paths);
  for (size_t i = 0; i < count; i++)
    if (!is_path(paths[i])) {
      try {
        require_path(paths[i]);
      } catch (const Failure &failure) {
        fail(failure.status, "paths[%zu]: %s", i, failure.what());
      }
    }
}

// Batches of elements with `values` floats each.
size_t value_batch(const TynContext &context, size_t count, size_t values) {
  const size_t bytes = values * sizeof(float);
  return batch_size(context, count, std::max<size_t>(MOST / values, 1), bytes, bytes, "value");
}

size_t item_count(const TynContext &context, size_t count) {
  const size_t row = TYN_BSSRDF_ROW * context.lanes();
  return (count + row - 1) / row;
}

template <class F>
void for_batches(size_t count, size_t batch, F &&f) {
  for (size_t first = 0; first < count; first += batch)
    f(first, std::min(batch, count - first));
}

// `kernel`: bssrdf_profile or bssrdf_density, of radii; bssrdf_evaluate, of paths.
void launch(TynBssrdf &bssrdf, const char *kernel, cl_mem inputs, size_t count, cl_mem values) {
  bssrdf.context.launch("bssrdf", kernel, item_count(bssrdf.context, count), 1, bssrdf.records, bssrdf.terms,
                        bssrdf.channels(), inputs, cl_ulong(count), values);
}

void launch_sample(TynBssrdf &bssrdf, uint64_t seed, uint64_t first, size_t count, cl_mem radii, cl_mem pdf,
                   cl_mem weights) {
  // a kernel has to be given a buffer, also where it is not used
  bssrdf.context.launch("bssrdf", "bssrdf_sample", item_count(bssrdf.context, count), 1, bssrdf.records, bssrdf.terms,
                        bssrdf.channels(), uint32_t(seed), uint32_t(seed >> 32), cl_ulong(first), cl_ulong(count),
                        radii, pdf, weights ? weights : pdf, uint32_t(weights != nullptr));
}

// What a kernel makes of radii or paths: `rows` values of each.
template <class Input>
void evaluate(TynBssrdf &bssrdf, const char *kernel, const Input *inputs, size_t count, uint32_t rows, float *values) {
  TynContext &context = bssrdf.context;
  const size_t batch = value_batch(context, count, sizeof(Input) / sizeof(float) + rows);
  Buffer in(context, batch * sizeof(Input), CL_MEM_READ_ONLY), out(context, batch * rows * sizeof(float));
  for_batches(count, batch, [&](size_t first, size_t size) {
    context.write(in, inputs + first, size * sizeof(Input));
    launch(bssrdf, kernel, in.get(), size, out.get());
    for (uint32_t row = 0; row < rows; row++)
      context.read(out, values + row * count + first, size * sizeof(float), row * size * sizeof(float));
  });
}

void sample(TynBssrdf &bssrdf, uint64_t seed, uint64_t first_sample, size_t count, float *radii, float *pdf,
            float *weights) {
  TynContext &context = bssrdf.context;
  const uint32_t rows = weights ? bssrdf.channels() : 0;
  const size_t batch = value_batch(context, count, 2 + size_t(rows));
  Buffer radius_buffer(context, batch * sizeof(float)), pdf_buffer(context, batch * sizeof(float));
  Buffer weight_buffer(context, batch * rows * sizeof(float));
  for_batches(count, batch, [&](size_t first, size_t size) {
    launch_sample(bssrdf, seed, first_sample + first, size, radius_buffer.get(), pdf_buffer.get(),
                  rows ? weight_buffer.get() : nullptr);
    context.read(radius_buffer, radii + first, size * sizeof(float));
    context.read(pdf_buffer, pdf + first, size * sizeof(float));
    for (uint32_t row = 0; row < rows; row++)
      context.read(weight_buffer, weights + row * count + first, size * sizeof(float), row * size * sizeof(float));
  });
}

void require_float_buffer(TynBssrdf &bssrdf, const char *name, cl_mem buffer, size_t count) {
  require_buffer(bssrdf.context, name, buffer, count, sizeof(float));
}

// At the C boundary: nothing is checked or done for no radii or paths.
template <class Body>
TynStatus for_count(TynBssrdf *bssrdf, size_t count, Body &&body) {
  if (!bssrdf)
    return TYN_ERROR_INVALID_ARGUMENT;
  return guarded(&bssrdf->context, [&] {
    if (count > 0)
      body();
  });
}

} // namespace
} // namespace tyn

using namespace tyn;

TynStatus tyn_bssrdf_profile(TynBssrdf *bssrdf, const float *radii, size_t count, float *profile) {
  return for_count(bssrdf, count, [&] {
    require_radii(radii, count);
    require_pointer("profile", profile);
    evaluate(*bssrdf, "bssrdf_profile", radii, count, bssrdf->channels(), profile);
  });
}

TynStatus tyn_bssrdf_profile_error(TynBssrdf *bssrdf, const float *radii, size_t count, float *errors) {
  return for_count(bssrdf, count, [&] {
    require_radii(radii, count);
    require_pointer("errors", errors);
    for (uint32_t c = 0; c < bssrdf->channels(); c++) {
      const Profile &profile = bssrdf->profiles[c];
      for (size_t i = 0; i < count; i++) {
        const double x = double(radii[i]) / profile.length, relative = profile_error(profile, x);
        const double value = relative > 0 ? profile_value(profile, x) / (profile.length * profile.length) : 0;
        errors[c * count + i] = float(relative * value);
      }
    }
  });
}

TynStatus tyn_bssrdf_pdf(TynBssrdf *bssrdf, const float *radii, size_t count, float *pdf) {
  return for_count(bssrdf, count, [&] {
    require_radii(radii, count);
    require_pointer("pdf", pdf);
    evaluate(*bssrdf, "bssrdf_density", radii, count, 1, pdf);
  });
}

TynStatus tyn_bssrdf_evaluate(TynBssrdf *bssrdf, const TynBssrdfPath *paths, size_t count, float *values) {
  return for_count(bssrdf, count, [&] {
    require_paths(paths, count);
    require_pointer("values", values);
    evaluate(*bssrdf, "bssrdf_evaluate", paths, count, bssrdf->channels(), values);
  });
}

TynStatus tyn_bssrdf_sample(TynBssrdf *bssrdf, uint64_t seed, uint64_t first, size_t count, float *radii, float *pdf,
                            float *weights) {
  return for_count(bssrdf, count, [&] {
    require_pointer("radii", radii);
    require_pointer("pdf", pdf);
    sample(*bssrdf, seed, first, count, radii, pdf, weights);
  });
}

TynStatus tyn_bssrdf_profile_cl(TynBssrdf *bssrdf, cl_mem radii, size_t count, cl_mem profile) {
  return for_count(bssrdf, count, [&] {
    require_float_buffer(*bssrdf, "radii", radii, count);
    require_float_buffer(*bssrdf, "profile", profile, count * bssrdf->channels());
    launch(*bssrdf, "bssrdf_profile", radii, count, profile);
    bssrdf->context.flush();
  });
}

TynStatus tyn_bssrdf_evaluate_cl(TynBssrdf *bssrdf, cl_mem paths, size_t count, cl_mem values) {
  return for_count(bssrdf, count, [&] {
    require_buffer(bssrdf->context, "paths", paths, count, sizeof(TynBssrdfPath));
    require_float_buffer(*bssrdf, "values", values, count * bssrdf->channels());
    launch(*bssrdf, "bssrdf_evaluate", paths, count, values);
    bssrdf->context.flush();
  });
}

TynStatus tyn_bssrdf_pdf_cl(TynBssrdf *bssrdf, cl_mem radii, size_t count, cl_mem pdf) {
  return for_count(bssrdf, count, [&] {
    require_float_buffer(*bssrdf, "radii", radii, count);
    require_float_buffer(*bssrdf, "pdf", pdf, count);
    launch(*bssrdf, "bssrdf_density", radii, count, pdf);
    bssrdf->context.flush();
  });
}

TynStatus tyn_bssrdf_sample_cl(TynBssrdf *bssrdf, uint64_t seed, uint64_t first, size_t count, cl_mem radii, cl_mem pdf,
                               cl_mem weights) {
  return for_count(bssrdf, count, [&] {
    require_float_buffer(*bssrdf, "radii", radii, count);
    require_float_buffer(*bssrdf, "pdf", pdf, count);
    if (weights)
      require_float_buffer(*bssrdf, "weights", weights, count * bssrdf->channels());
    launch_sample(*bssrdf, seed, first, count, radii, pdf, weights);
    bssrdf->context.flush();
  });
}
