// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace tyn {

// Mean of 1 - F over cosine-distributed light that meets a smooth dielectric from outside: c = 2 int_0^1 (1 - F(mu)) mu dmu.
// `ior` >= 1: index inside over index outside. Error below 1e-9.
double mean_transmittance(double ior);

} // namespace tyn
