/* SPDX-License-Identifier: Apache-2.0 */
/*
 * Tyndall: models of the BSSRDF behind one interface.
 *
 * A BSSRDF S(x_i, w_i; x_o, w_o) says how much of the light that arrives at x_i along w_i leaves at x_o along w_o. What all
 * models here have is the profile R(r): the radiant exitance at distance r from a point where light gets in perpendicularly,
 * per unit of power that gets in, 1/length^2. Its integral over the plane, int 2 pi r R(r) dr, is the albedo: the fraction of
 * that light that comes back scattered. (Of light that arrives, the surface's Fresnel reflection does not get in.)
 * Most models know no directions: for them S is the separable F_t(w_i) R(|x_o - x_i|) F_t(w_o) / (pi c) with Fresnel's
 * transmittances F_t and c = 2 int_0^1 F_t(mu) mu dmu, so that the exitance int S cos dw_o is F_t(w_i) R, from wherever light
 * arrives. DIRECTIONAL_DIPOLE depends on where light comes from, and on how the surface is turned; its R is its exitance where
 * light gets in perpendicularly and the surface is flat. See tyn_bssrdf_evaluate.
 * Models are approximations, made for a flat surface. Their files in lib/bssrdf name the papers and equations, and
 * docs/bssrdf-models.md has their measured errors. Their albedos are as good as they are: only EXACT's and normalized
 * diffusion's are exact; photon beam diffusion's is 1.09 for a white, index-matched medium; SINGLE_SCATTERING lacks what
 * boundaries send back inside, the better dipole and quantized diffusion lack single scattering; the directional dipole's are
 * far too large: 1.09 and 0.80 for alpha' = 0.99 and indices of 1 and 1.4 (exact: 0.75 and 0.62), 0.35 and 0.19 for
 * alpha' = 0.5 (0.12 and 0.05); they do not go to 0 with the scattering (0.21 and 0.12), but where there is none they are 0.
 *
 * Media are those of tyndall_slab.h. A half-space is a TynSlab of one infinite layer; GAUSSIANS and SINGLE_SCATTERING take one
 * layer of any thickness, MULTIPOLE 1 .. 64 layers. N spectral channels, each with a profile of its own. Arrays of several
 * channels are stored channel by channel: value [channel * count + i].
 *
 * EXACT is no approximation but an estimate: single scattering in closed form, all else from walks of the slab engine in a
 * white half-space of the medium's phase function and index of refraction, lower than outside or higher. A walk of n
 * scattering events keeps albedo^n of its weight, so that one run answers for all albedos; beyond the orders that are
 * walked light is diffuse and falls like n^(-3/2). Totals are those of adding and doubling. A table is made where the
 * context's cache folder has none for that phase function and index: 4 to 8 s on two cores; tables of another device are
 * read, too. Mean cosines of the phase function up to 0.999. It says its standard errors (tyn_bssrdf_profile_error), but
 * for what the assumption of diffuse light beyond the last order is wrong by: 0.1 to 1 % over six decades of R in an
 * isotropic medium, 0.3 to 2 % for g = 0.95. S is exact, averaged over the azimuth and resolved to half octaves of r and
 * eighths of the squared cosine, where light gets in or leaves perpendicularly, and where all of it is diffuse; else a
 * product joins what the two directions have (kernels/bssrdf_angles.clh), which is worst near the point where light gets
 * in: of all light that arrives at 40 (69) degrees 5 (7) % too much comes back for an index of 1.4 and an albedo of 0.9, 23
 * (25) % for 1 and 0.6.
 *
 * MULTIPOLE takes layers that are thicker than a reduced mean free path, 1 / (sigma_a + sigma_s (1 - g)), in every channel, as
 * their light's source is that deep; the last one may be infinite. Of several layers each must scatter in every channel, but
 * an infinite last one, which then is black: light that gets through a layer unscattered is not in the model. Indices of
 * refraction may differ from layer to layer and be higher or lower than those outside. As light is taken to enter every layer
 * as if it came perpendicularly, two layers of one medium are not quite one of twice the thickness: what two layers of 5 (20)
 * mean free paths each and albedo 0.99 transmit is 5 % more in all and 16 % (7 %) more below the beam, while far away both R(r)
 * and T(r) fall off faster. So do not cut layers without need. Where a layer that is barely thick enough has a highly
 * reflective surface, R(r) of the model turns negative far away; it is cut off there.
 */
#ifndef TYNDALL_BSSRDF_H
#define TYNDALL_BSSRDF_H

#include "tyndall_slab.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Name of a model, TYN_BSSRDF_* of tyndall_types.h: "standard-dipole", "better-dipole", "photon-beam-diffusion", "multipole",
 * "normalized-diffusion", "gaussians", "single-scattering", "quantized-diffusion", "directional-dipole", "exact"; NULL for no
 * such model. */
TYN_API const char *tyn_bssrdf_model_name(uint32_t model);

/* The model of that name; TYN_BSSRDF_MODEL_COUNT if there is none. `name`: may be NULL. */
TYN_API uint32_t tyn_bssrdf_find_model(const char *name);

typedef struct TynBssrdfOptions {
  size_t size;             /* sizeof(TynBssrdfOptions) */
  uint32_t model;          /* TYN_BSSRDF_*; default STANDARD_DIPOLE */
  uint32_t fit;            /* NORMALIZED_DIFFUSION: TYN_NORMALIZED_*; default SEARCHLIGHT */
  uint32_t transmitted;    /* MULTIPOLE: 1: what leaves below (nothing if the last layer is infinite); 0 (default): what
                              comes back */
  uint32_t gaussian_count; /* GAUSSIANS: in each channel, 1 .. 64 */
  const double
      *gaussian_weights; /* GAUSSIANS: channel_count x gaussian_count, >= 0; a channel's sum, its albedo, at most 1 */
  const double *gaussian_variances; /* GAUSSIANS: as many, > 0, length^2: of x and of y; within a factor of 1e20 */
  uint64_t exact_events;            /* EXACT: scattering events that a table is made of, 1 .. 1e15; default 1.5e9 */
  TynProgress progress;             /* EXACT: called while a table is made; may be NULL */
  void *user;                       /* passed to progress */
} TynBssrdfOptions;

static inline TynBssrdfOptions tyn_bssrdf_options(void) {
  TynBssrdfOptions options;
  memset(&options, 0, sizeof options);
  options.size = sizeof options;
  options.exact_events = 1500000000;
  return options;
}

/* A model of a medium, ready for the device. Never changes; used from one thread at a time with its context. */
typedef struct TynBssrdf TynBssrdf;

/* Prepares a model: some milliseconds a channel, up to 0.2 s where it is tabulated, seconds where EXACT has to make a table.
 * `slab`, `options`: not NULL; nothing of them is kept. `bssrdf`: set to NULL on failure.
 * Errors: INVALID_ARGUMENT (no such model: the message lists them; more layers, or another thickness, than the model takes; a
 * layer of several that does not scatter; an index of refraction below that outside, but for EXACT, GAUSSIANS and MULTIPOLE;
 * the fit DMFP without absorption; exact_events too few for the medium; mean free paths outside [1e-18, 1e18], or the sum of
 * thicknesses where it is the unit of what several layers transmit), OUT_OF_MEMORY, DEVICE, KERNEL_BUILD, CANCELLED. */
TYN_API TynStatus tyn_bssrdf_create(TynContext *context, const TynSlab *slab, const TynBssrdfOptions *options,
                                    TynBssrdf **bssrdf);
TYN_API void tyn_bssrdf_retain(TynBssrdf *bssrdf);
TYN_API void tyn_bssrdf_release(TynBssrdf *bssrdf);

/* Copies the albedo of each channel, int 2 pi r R(r) dr. `count`: the number of channels, else
 * INVALID_ARGUMENT. */
TYN_API TynStatus tyn_bssrdf_albedo(const TynBssrdf *bssrdf, double *albedo, size_t count);

/* R at `count` radii, which are > 0 and finite. `profile`: channel_count x count, 1/length^2. Single precision: 1e-5, or what a
 * float's exponent leaves of a small value. Tables reach from 2^-12 to 2^12 times a length: a reduced mean free path of the top
 * layer (up to 32 of them where deeper layers have longer ones), or the sum of thicknesses for what several layers transmit.
 * Nearer R is continued as a constant or like 1/r, farther by its falloff; beyond 1e12 it is 0.
 * Errors here and below: INVALID_ARGUMENT (which radius), OUT_OF_MEMORY, DEVICE, KERNEL_BUILD. */
TYN_API TynStatus tyn_bssrdf_profile(TynBssrdf *bssrdf, const float *radii, size_t count, float *profile);

/* Standard errors of tyn_bssrdf_profile at `count` radii, which are > 0 and finite: of EXACT, whose tables are estimates; 0 for
 * all other models, which are wrong in other ways. `errors`: channel_count x count, 1/length^2. Computed on the host. Where a
 * table is continued beyond what was counted (the last factor of two or so of the radius at which R is known to 5 %) it says
 * what it was there. */
TYN_API TynStatus tyn_bssrdf_profile_error(TynBssrdf *bssrdf, const float *radii, size_t count, float *errors);

/* Draws `count` radii with a density like R's: of a channel that is chosen in proportion to its albedo. Radius i is a function
 * of seed and first + i alone. `pdf`: density per area of the plane, 1/length^2, over all channels: what tyn_bssrdf_pdf gives.
 * `weights`: channel_count x count, R / pdf, which add up to the albedos on average; they are bounded, nearly always by 1.5
 * times the sum of all albedos, by some 20 times in the far tail of a slab's single scattering. May be NULL. Where no channel
 * has an albedo, radii, pdf and weights are 0. */
TYN_API TynStatus tyn_bssrdf_sample(TynBssrdf *bssrdf, uint64_t seed, uint64_t first, size_t count, float *radii,
                                    float *pdf, float *weights);

/* The density of tyn_bssrdf_sample at `count` radii, which are > 0 and finite, 1/length^2: int 2 pi r pdf(r) dr = 1. */
TYN_API TynStatus tyn_bssrdf_pdf(TynBssrdf *bssrdf, const float *radii, size_t count, float *pdf);

/* The BSSRDF S(x_i, w_i; x_o, w_o) of `count` paths: the radiance that leaves at x_o along w_o per unit of power that arrives
 * at x_i along w_i (arrives: what the surface reflects there is counted, too), 1/(length^2 sr).
 * `paths`: not NULL; see TynBssrdfPath of tyndall_types.h. Positions are finite, normals and directions of unit length within
 * 1e-3. Light that arrives from inside (entry_direction . entry_normal >= 0) or leaves to the inside (exit_direction .
 * exit_normal <= 0) gives 0. Where light leaves on the other side of a slab (MULTIPOLE with `transmitted`), the exit's normal
 * is that of the other side, and r is the distance perpendicular to the entry's normal.
 * `values`: not NULL, channel_count x count, finite, >= 0. Single precision: as R, and 1e-5; for the directional dipole 1e-4,
 * and 1e-5 of what each of its two sources gives. Points nearer than 1e-12 mean free paths count as that far from each other;
 * beyond 1e12 S is 0; what a float cannot hold is its largest number. `count` 0 does nothing.
 * Light that comes back is reciprocal in all models but one: exchanging entry and exit, and turning the directions round, gives
 * the same bits. (Light that MULTIPOLE transmits is, only where the slab is the same from below.) DIRECTIONAL_DIPOLE is not: it
 * tells the directions of light that arrives, not those of light that leaves. It is defined for curved surfaces, too; where the
 * surface at x_o is lit from behind (n_o . w > 0, w the refracted direction), it jumps.
 * Errors: INVALID_ARGUMENT (which path, which member), OUT_OF_MEMORY, DEVICE, KERNEL_BUILD; `values` is not written if a path
 * is refused. */
TYN_API TynStatus tyn_bssrdf_evaluate(TynBssrdf *bssrdf, const TynBssrdfPath *paths, size_t count, float *values);

#ifdef __cplusplus
}
#endif

#endif
