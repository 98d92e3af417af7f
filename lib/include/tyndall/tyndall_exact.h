/* SPDX-License-Identifier: Apache-2.0 */
/*
 * Tyndall: exact results of plane-parallel transport, on the host in double precision: adding-doubling for layered slabs, the
 * half-space of Chandrasekhar, and the closed forms of Hanrahan's lecture on participating media (CS348B, 2005): reduced
 * intensity, effective source, Seeliger's law, and the single scattering of a finite slab (Hanrahan & Krueger 1993).
 *
 * mu is the cosine of the angle from the normal, in (0, 1]; tau an optical depth; "albedo" the single-scattering albedo W.
 * Functions that return a double return NaN for arguments out of range; those that return a status answer INVALID_ARGUMENT to
 * them and to NULL where it is not allowed, and write nothing then.
 */
#ifndef TYNDALL_EXACT_H
#define TYNDALL_EXACT_H

#include "tyndall_slab.h"

#ifdef __cplusplus
extern "C" {
#endif

/* ---- Closed forms -------------------------------------------------------------------------------------------------- */

/* Reduced intensity: the fraction of light that reaches optical depth tau along a direction of cosine mu without an event,
 * exp(-tau / mu). tau >= 0. */
TYN_API double tyn_reduced_intensity(double tau, double mu);

/* Effective source: radiance scattered once per optical depth into a direction at optical depth tau, for a collimated beam of
 * unit irradiance (across the beam) that entered along mu_i: W p exp(-tau / mu_i). `phase`: p(cos) between the two directions,
 * 1/sr. */
TYN_API double tyn_effective_source(double albedo, double phase, double tau, double mu_i);

/* Seeliger's law: BRDF of single scattering in an index-matched half-space, W p / (mu_i + mu_o) (Seeliger 1887; the lecture's
 * semi-infinite medium). `phase`: p(cos), 1/sr. */
TYN_API double tyn_seeliger_brdf(double albedo, double phase, double mu_i, double mu_o);

/* A layer lit and seen from the same medium (ior 1) on both sides. */
typedef struct TynSingleScattering {
  size_t size;
  double albedo;            /* [0, 1] */
  double optical_thickness; /* sigma_t x thickness, > 0; INFINITY (default): half-space */
  double ior;               /* of the layer relative to outside, [1, 4]; default 1 */
  const TynPhase *phase;    /* NULL (default): isotropic */
} TynSingleScattering;

static inline TynSingleScattering tyn_single_scattering(void) {
  TynSingleScattering layer;
  memset(&layer, 0, sizeof layer);
  layer.size = sizeof layer;
  layer.optical_thickness = (double)INFINITY;
  layer.ior = 1.0;
  return layer;
}

/* BRDF and BTDF of single scattering in a finite slab with Fresnel boundaries, without light that boundaries reflect back
 * inside (Hanrahan & Krueger 1993, the first-order terms; in the limit of an index-matched half-space, Seeliger's law). Cosines are
 * those outside, of the direction to the light and of the direction to the viewer (above for the BRDF, below for the BTDF),
 * in (0, 1]; `azimuth`: between the two, radians; 0 means that light and viewer are on the same side of the normal.
 * `brdf`, `btdf`: 1/sr; either may be NULL. */
TYN_API TynStatus tyn_hanrahan_krueger(const TynSingleScattering *layer, double mu_i, double mu_o, double azimuth,
                                       double *brdf, double *btdf);

/* ---- Chandrasekhar's half-space ---------------------------------------------------------------------------------------- */

/* H(mu) for isotropic scattering: H = 1 + mu H(mu) W/2 int_0^1 H(x) / (mu + x) dx (Chandrasekhar 1950, chapter V), for `count`
 * cosines in [0, 1], to 1e-12. albedo in [0, 1]. */
TYN_API TynStatus tyn_chandrasekhar_h(double albedo, const double *mu, size_t count, double *h);

/* BRDF of the index-matched, isotropically scattering half-space, all orders: W / (4 pi) H(mu_i) H(mu_o) / (mu_i + mu_o), 1/sr,
 * for one mu_i and `count` mu_o. */
TYN_API TynStatus tyn_half_space_brdf(double albedo, double mu_i, const double *mu_o, size_t count, double *brdf);

/* Its directional albedo: 1 - H(mu) sqrt(1 - W). */
TYN_API TynStatus tyn_half_space_albedo(double albedo, double mu, double *directional_albedo);

/* ---- Adding-doubling ------------------------------------------------------------------------------------------------ */

typedef struct TynAddingDoublingOptions {
  size_t size;
  uint32_t channel;      /* of the slab; default 0 */
  uint32_t incidence;    /* TYN_INCIDENCE_* */
  double angle;          /* COLLIMATED: from the normal, in the medium above, radians, [0, pi/2) */
  double tolerance;      /* wanted accuracy of the totals, [1e-10, 0.1]; default 1e-6 */
  uint32_t max_nodes;    /* most quadrature nodes, 8 .. 512; default 192. More are tried until the tolerance is met. */
  const double *cosines; /* angular output at these, (0, 1]; NULL (default) if there is none */
  size_t cosine_count;
} TynAddingDoublingOptions;

static inline TynAddingDoublingOptions tyn_adding_doubling_options(void) {
  TynAddingDoublingOptions options;
  memset(&options, 0, sizeof options);
  options.size = sizeof options;
  options.tolerance = 1e-6;
  options.max_nodes = 192;
  return options;
}

/* Fractions of the light that arrives. */
typedef struct TynAddingDoublingResult {
  size_t size;                 /* set by the caller */
  double reflectance;          /* all that comes back, unscattered light included */
  double transmittance;        /* all that goes through */
  double absorbed;             /* the rest */
  double specular_reflectance; /* comes back unscattered */
  double direct_transmittance; /* goes through unscattered */
  double
      accuracy; /* reached: the larger change of R and T from the last refinement of the quadrature. Above `tolerance` if
                      max_nodes did not suffice; the call succeeds all the same. */
  uint32_t nodes; /* of the quadrature that was used */
} TynAddingDoublingResult;

/* Reflectance and transmittance of a slab by adding and doubling (van de Hulst 1980; Prahl 1995), with delta-M scaling of the
 * phase function (Wiscombe 1977) where its Legendre series is longer than the quadrature resolves.
 * `reflected`, `transmitted`: scattered light per solid angle, 1/sr (BRDF x cosine, mean over azimuth), at options->cosines in
 * the medium above and in the medium below; each may be NULL. A transmitted direction below an infinite layer is 0. Refined on
 * until they change by less than 10 x tolerance, or max_nodes: `accuracy` and `nodes` speak of the totals. What delta-M takes for
 * unscattered, the sharpest part of a forward peak, is missing from `transmitted`.
 * Errors: INVALID_ARGUMENT, OUT_OF_MEMORY. `message`, of `message_capacity` bytes, receives what was wrong; may be NULL. */
TYN_API TynStatus tyn_adding_doubling(const TynSlab *slab, const TynAddingDoublingOptions *options,
                                      TynAddingDoublingResult *result, double *reflected, double *transmitted,
                                      char *message, size_t message_capacity);

#ifdef __cplusplus
}
#endif

#endif
