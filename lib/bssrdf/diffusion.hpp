// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
// What the diffusion models share: reduced coefficients, and what a boundary does to diffuse light.
#pragma once

#include "bssrdf/model.hpp"

namespace tyn {

// Similarity: as if scattering were isotropic.
struct ReducedMedium {
  double sigma_s; // sigma_s (1 - g), g the mean cosine
  double sigma_t; // sigma_a + sigma_s
  double albedo;  // sigma_s / sigma_t; 0 in a clear medium
};

ReducedMedium reduced(const SlabLayer &layer, uint32_t channel);

// Moments of what a boundary reflects of light from inside: c1 = int_0^1 F(mu) mu dmu, c2 = int_0^1 F(mu) mu^2 dmu. `eta`:
// index inside over index outside, > 0. By quadrature, where d'Eon & Irving 2011 have polynomials that are fitted to them.
struct FresnelMoments {
  double c1, c2;
};

FresnelMoments fresnel_moments(double eta);

// A = (1 + F_dr) / (1 - F_dr) of Jensen et al. 2001 with the fit of F_dr by Egan & Hilgeman 1979 that they use, and that of
// Donner & Jensen 2005 for eta < 1. Beyond 2 and below 0.5, where the fits go wrong (they come to exceed 1), F_dr = 2 c1.
double internal_reflection_fit(double eta);

// The exitance of a fluence phi and a flux E . n at the surface is C_phi phi + C_E E . n; light seems to vanish at the distance
// 2 A D beyond it (d'Eon 2012, "A Better Dipole").
struct ExitanceBoundary {
  double c_phi, c_e, a;
};

ExitanceBoundary exitance_boundary(double eta);

// Grosjean's diffusion coefficient and the rate at which light then falls off, both in units of 1 / sigma_t' (d'Eon 2012).
struct GrosjeanDiffusion {
  double d, falloff;

  explicit GrosjeanDiffusion(double reduced_albedo);
};

} // namespace tyn
