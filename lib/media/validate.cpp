// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include "core/input.hpp"
#include "media/media.hpp"
#include "media/phase.hpp"

namespace tyn {
namespace {

void require_coefficient(const char *field, int channel, float value) {
  if (!std::isfinite(value) || value < 0.0f)
    fail(TYN_ERROR_INVALID_ARGUMENT, "TynMedium::%s[%d] is %g; allowed: finite, >= 0", field, channel,
         static_cast<double>(value));
}

// Says which struct the phase function is in.
void require_phase(const TynPhase &given) {
  try {
    validate(read_struct("TynPhase", &given, tyn_phase()));
  } catch (const Failure &failure) {
    fail(failure.status, "TynMedium::phase: %s", failure.what());
  }
}

} // namespace

TynMedium read_medium(const TynMedium *given) {
  require_pointer("TynMedium", given);
  if (given->size != first_medium_size) // no size in between is a version's
    require_size("TynMedium", given->size, sizeof(TynMedium), sizeof(TynMedium));
  const TynMedium medium = read_struct("TynMedium", given, tyn_medium(), first_medium_size);
  validate(medium);
  return medium;
}

void validate(const TynMedium &medium) {
  if (medium.size < sizeof(TynMedium))
    fail(TYN_ERROR_INVALID_ARGUMENT, "TynMedium::size is %zu; start from tyn_medium()", medium.size);
  for (int channel = 0; channel < 3; ++channel) {
    const float absorption = medium.sigma_a[channel];
    const float scattering = medium.sigma_s[channel];
    require_coefficient("sigma_a", channel, absorption);
    require_coefficient("sigma_s", channel, scattering);
    if (!std::isfinite(absorption + scattering))
      fail(TYN_ERROR_INVALID_ARGUMENT, "TynMedium::sigma_a[%d] + sigma_s[%d] is %g + %g; allowed: a finite sum",
           channel, channel, static_cast<double>(absorption), static_cast<double>(scattering));
  }
  if (medium.phase)
    require_phase(*medium.phase);
  else if (!(medium.g > -1.0f && medium.g < 1.0f))
    fail(TYN_ERROR_INVALID_ARGUMENT, "TynMedium::g is %g; allowed: -1 < g < 1", static_cast<double>(medium.g));
  if (!(medium.ior >= 1.0f && medium.ior <= 4.0f))
    fail(TYN_ERROR_INVALID_ARGUMENT, "TynMedium::ior is %g; allowed: 1 to 4", static_cast<double>(medium.ior));
}

} // namespace tyn
