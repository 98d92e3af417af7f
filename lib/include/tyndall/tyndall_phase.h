/* SPDX-License-Identifier: Apache-2.0 */
/*
 * Tyndall: phase functions, and Lorenz-Mie scattering by spheres.
 *
 * A phase function p(cos) is the density per solid angle of the direction after a scattering event, with cos = w . w' between
 * the directions of travel before and after: 1 is straight on. Its integral over the sphere is 1 (1/sr). All of these are
 * reciprocal, as they depend on cos alone.
 */
#ifndef TYNDALL_PHASE_H
#define TYNDALL_PHASE_H

#include "tyndall_base.h"
#include "tyndall_types.h"

#ifdef __cplusplus
extern "C" {
#endif

/* A phase function; its kinds are in tyndall_types.h. Members that its kind does not use are ignored. */
typedef struct TynPhase {
  size_t size;           /* sizeof(TynPhase) */
  uint32_t kind;         /* TYN_PHASE_* */
  double g;              /* HENYEY_GREENSTEIN, TWO_LOBE, DRAINE: in (-1, 1) */
  double g2;             /* TWO_LOBE: in (-1, 1) */
  double weight;         /* TWO_LOBE: of the first lobe, [0, 1] */
  double alpha;          /* DRAINE: [0, 1e6]; 0 is Henyey-Greenstein, 1 with g = 0 Rayleigh, 1 Cornette & Shanks 1992 */
  const double *cosines; /* TABULATED: `count` of them, strictly increasing from -1 to 1. The caller's: whoever takes a
                            TynPhase copies what it keeps. */
  const double *values;  /* TABULATED: >= 0 and finite; any scale; their integral at least 1e-18 of their largest */
  uint32_t count;        /* TABULATED: 2 .. 65536 */
} TynPhase;

/* Defaults: isotropic; g = g2 = 0, weight = 1, alpha = 0, no table. */
static inline TynPhase tyn_phase(void) {
  TynPhase phase;
  memset(&phase, 0, sizeof phase);
  phase.size = sizeof phase;
  phase.weight = 1.0;
  return phase;
}

/* Name of a kind: "isotropic", "rayleigh", "henyey-greenstein", "two-lobe", "draine", "tabulated"; NULL for no such kind. */
TYN_API const char *tyn_phase_name(uint32_t kind);

/* p(cos) in 1/sr for `count` cosines in [-1, 1]. INVALID_ARGUMENT for a bad phase function, a cosine out of range, NULL. */
TYN_API TynStatus tyn_phase_value(const TynPhase *phase, const double *cosines, size_t count, double *values);

/* Draws `count` cosines with density 2 pi p(cos) d cos from a stream of random numbers: the same code as on the device, in
 * single precision. `seed` and `first` choose the numbers: cosine i is a function of seed and first + i alone. */
TYN_API TynStatus tyn_phase_sample(const TynPhase *phase, uint64_t seed, uint64_t first, size_t count, double *cosines);

/* Density of tyn_phase_sample with respect to cos, 2 pi p(cos): exact, as every kind is sampled by its own density. */
TYN_API TynStatus tyn_phase_pdf(const TynPhase *phase, const double *cosines, size_t count, double *pdf);

/* Legendre moments chi_l = 2 pi int p(cos) P_l(cos) d cos for l = 0 .. count - 1; chi_0 = 1, chi_1 is the mean cosine. */
TYN_API TynStatus tyn_phase_moments(const TynPhase *phase, size_t count, double *moments);

/* The mean cosine: chi_1. */
TYN_API TynStatus tyn_phase_mean_cosine(const TynPhase *phase, double *mean_cosine);

/* Rayleigh scattering cross-section of a small sphere, in the square of the unit of `radius`:
 * 8 pi / 3 (2 pi / lambda)^4 a^6 |(m^2 - 1) / (m^2 + 2)|^2 (Bohren & Huffman 1983, eq. 5.8): lambda^-4.
 * radius >= 0, wavelength (in the surrounding medium) > 0; m = relative_index[0] + i relative_index[1], as in
 * tyn_mie. */
TYN_API TynStatus tyn_rayleigh_cross_section(double radius, double wavelength, const double relative_index[2],
                                             double *cross_section);

/* ---- Lorenz-Mie ---------------------------------------------------------------------------------------------------- */

/* Scattering by one sphere (Bohren & Huffman 1983, chapter 4 and appendix A). Efficiencies are cross-sections divided by the
 * geometric one, pi a^2. */
typedef struct TynMie {
  double q_ext, q_sca, q_abs, q_back; /* q_back: 4 pi dC/dOmega(180 degrees) / (pi a^2) */
  double mean_cosine;
} TynMie;

/* `size_parameter` x = 2 pi a / lambda in (0, 1e5], lambda in the surrounding medium. `relative_index`: m = n + i k relative to
 * it, n > 0, k >= 0 (k > 0 absorbs), |m| in [1e-3, 1e3]; of m = 1, which scatters nothing, p is isotropic. `mie`: may be NULL. With `count` > 0: values[i] receives p(cosines[i]) in 1/sr for
 * unpolarized light, cosines in [-1, 1]. */
TYN_API TynStatus tyn_mie(double size_parameter, const double relative_index[2], TynMie *mie, const double *cosines,
                          size_t count, double *values);

/* Spheres with log-normal radii: the logarithm of the radius is normal with mean log(median_radius) and standard deviation
 * log(geometric_deviation). */
typedef struct TynMieDistribution {
  size_t size;
  double median_radius;       /* > 0 */
  double geometric_deviation; /* >= 1; 1: all alike. At most 5. */
  double wavelength;          /* > 0, in the surrounding medium, in the unit of the radius */
  double relative_index[2];   /* n > 0, k >= 0 */
} TynMieDistribution;

static inline TynMieDistribution tyn_mie_distribution(void) {
  TynMieDistribution distribution;
  memset(&distribution, 0, sizeof distribution);
  distribution.size = sizeof distribution;
  distribution.geometric_deviation = 1.0;
  return distribution;
}

/* Means over the distribution, per particle, in the square of the unit of the radius: multiplied by the number of particles
 * per volume they are sigma_s and sigma_a. */
typedef struct TynMieCrossSections {
  double extinction, scattering, absorption;
  double mean_cosine; /* of the scattered light */
} TynMieCrossSections;

/* `cross_sections`: may be NULL. With `count` > 0: values[i] receives p(cosines[i]), weighted by scattering cross-section.
 * To 1e-6 where spheres are small; large ones keep 1e-4 in p. A wide distribution of large spheres takes many seconds. A distribution that reaches
 * size parameters above 1e5 is INVALID_ARGUMENT. */
TYN_API TynStatus tyn_mie_lognormal(const TynMieDistribution *distribution, TynMieCrossSections *cross_sections,
                                    const double *cosines, size_t count, double *values);

/* Cosines for a table of the phase function of spheres up to `size_parameter`: `count` (2 .. 65536) increasing from -1 to 1,
 * denser towards 1, where the diffraction peak is of width 1 / x. */
TYN_API TynStatus tyn_mie_cosines(double size_parameter, size_t count, double *cosines);

#ifdef __cplusplus
}
#endif

#endif
