/* SPDX-License-Identifier: Apache-2.0 */
/*
 * Tyndall: exact transport in half-spaces and layered slabs, by Monte Carlo.
 *
 * A slab is a stack of plane layers between two half-spaces, "above" and "below". Light comes from above at the origin and
 * travels down. Layers are infinite sideways; only the last one may be infinitely thick. Interfaces are smooth, with
 * unpolarized Fresnel reflection. Lengths are in one unit of the caller's choice, coefficients in its inverse.
 */
#ifndef TYNDALL_SLAB_H
#define TYNDALL_SLAB_H

#include "tyndall_phase.h"

#ifdef __cplusplus
extern "C" {
#endif

/* One layer. */
typedef struct TynSlabLayer {
  size_t size;           /* sizeof(TynSlabLayer), the same in every layer of an array */
  const double *sigma_a; /* absorption in each spectral channel, 1/length, >= 0, with sigma_s at most 1e30; not NULL */
  const double *sigma_s; /* scattering in each channel, 1/length, >= 0; not NULL */
  double g; /* mean cosine of the Henyey-Greenstein phase function, in (-1, 1); ignored if there is a `phase` */
  const TynPhase *phase; /* NULL (default): Henyey-Greenstein with g */
  double ior;            /* [1, 4]; default 1 */
  double thickness;      /* > 0, at most 1e20; INFINITY (default) in the last layer only */
} TynSlabLayer;

static inline TynSlabLayer tyn_slab_layer(void) {
  TynSlabLayer layer;
  memset(&layer, 0, sizeof layer);
  layer.size = sizeof layer;
  layer.ior = 1.0;
  layer.thickness = (double)INFINITY;
  return layer;
}

/* A stack of layers, from the top. Nothing is kept after a call. */
typedef struct TynSlab {
  size_t size;                /* sizeof(TynSlab) */
  uint32_t channel_count;     /* spectral channels, 1 .. 1024; default 1 */
  uint32_t layer_count;       /* 1 .. 64 */
  const TynSlabLayer *layers; /* `layer_count` of them; not NULL */
  double ior_above;           /* [1, 4]; default 1 */
  double ior_below;           /* [1, 4]; default 1; without effect below an infinite layer */
} TynSlab;

static inline TynSlab tyn_slab(void) {
  TynSlab slab;
  memset(&slab, 0, sizeof slab);
  slab.size = sizeof slab;
  slab.channel_count = 1;
  slab.ior_above = 1.0;
  slab.ior_below = 1.0;
  return slab;
}

typedef struct TynSlabOptions {
  size_t size;         /* sizeof(TynSlabOptions) */
  uint32_t incidence;  /* TYN_INCIDENCE_*; default COLLIMATED */
  double angle;        /* COLLIMATED: from the normal, in the medium above, radians, [0, pi/2) */
  uint32_t beam;       /* TYN_BEAM_*; default PENCIL */
  double beam_radius;  /* DISC, GAUSSIAN: > 0, length */
  uint64_t photons;    /* a channel; at most 1e15; 0: no limit. Default 1e6 */
  double seconds;      /* wall-clock; 0 (default): no limit */
  double target_error; /* stops when the standard errors of the total reflectance and transmittance of every channel are
                          below it; 0 (default): none. Looked at at fixed photon counts, so where it stops is reproducible. */
  uint64_t seed;
  uint32_t max_order;          /* walks end when they would scatter once more; 0 (default): no limit */
  double roulette_threshold;   /* walks whose weight falls below it play Russian roulette, (0, 1]; default 0.1 */
  double radial_max;           /* radius at which R(r) and T(r) end, length, > 0 if there are bins */
  uint32_t radial_bins;        /* equal steps from 0 to radial_max; 0 (default): none. Bins of each kind: at most 1e6 */
  uint32_t angular_bins;       /* equal steps of the angle from the normal, 0 to pi/2; 0 (default): none */
  uint32_t radial_angular;     /* 1: R(r, angle) and T(r, angle) too, over the bins of both; default 0 */
  double depth_max;            /* depth at which absorption and fluence end, length, > 0 if there are bins */
  uint32_t depth_bins;         /* equal steps from 0 to depth_max; 0 (default): none */
  uint32_t order_bins;         /* scattering orders 0 .. order_bins - 1; 0 (default): none */
  double path_max;             /* path length at which its distribution ends, length, > 0 if there are bins */
  uint32_t path_bins;          /* equal steps from 0 to path_max; 0 (default): none */
  uint32_t sweep_count;        /* other media that the same photons answer for, at most 4096, not with max_order;
                                  0 (default): none */
  const double *sweep_sigma_a; /* sweep_count x layer_count, 1/length; read during the call */
  const double
      *sweep_sigma_s;   /* the same. Each row needs, in every layer and channel, sigma_s at most the layer's own and
                                  sigma_a + sigma_s at least the layer's own, so that weights stay bounded: give the slab
                                  the highest albedo (or the lowest sigma_a) of the sweep. */
  TynProgress progress; /* may be NULL */
  void *user;           /* passed to progress */
} TynSlabOptions;

static inline TynSlabOptions tyn_slab_options(void) {
  TynSlabOptions options;
  memset(&options, 0, sizeof options);
  options.size = sizeof options;
  options.photons = 1000000;
  options.roulette_threshold = 0.1;
  return options;
}

/* A Monte Carlo estimate and its standard error, from the means of independent batches; NaN if there was but one batch (a
 * single photon, or bins so many that one batch holds all photons). */
typedef struct TynEstimate {
  double value;
  double standard_error;
} TynEstimate;

/* Fractions of the light that arrived. specular + diffuse reflectance + direct + diffuse transmittance + absorbed + cut = 1
 * within rounding. */
typedef struct TynSlabTotals {
  size_t size;                       /* set by the caller */
  TynEstimate specular_reflectance;  /* comes back without having been scattered, from whichever interface */
  TynEstimate diffuse_reflectance;   /* comes back scattered */
  TynEstimate reflectance;           /* the sum of the two */
  TynEstimate direct_transmittance;  /* goes through without having been scattered */
  TynEstimate diffuse_transmittance; /* goes through scattered */
  TynEstimate transmittance;         /* the sum of the two */
  TynEstimate absorbed;              /* in all layers */
  TynEstimate cut;                   /* left in walks that max_order ended, or that are trapped between interfaces */
} TynSlabTotals;

/* What a run was. A NULL or wrong `size` in the calls below is INVALID_ARGUMENT; there is no message, as there is no context. */
typedef struct TynSlabRun {
  size_t size;          /* set by the caller */
  uint64_t photons;     /* walked to their ends, a channel */
  uint64_t events;      /* scattering events, all channels */
  double seconds;       /* wall-clock, compiling kernels excluded */
  double build_seconds; /* spent on getting the kernel ready */
  uint64_t seed;
  uint32_t channel_count, layer_count;
} TynSlabRun;

/* What is resolved: how many values, and what they are. Reflected and transmitted light is diffuse light (scattered at least
 * once) unless said otherwise; each REFLECTANCE is followed by its TRANSMITTANCE.
 *   LAYER_ABSORBED   layer_count: fraction absorbed in each layer
 *   RADIAL           radial_bins: mean over the ring, 1/length^2
 *   ANGULAR          angular_bins: per solid angle in the medium above (below), 1/sr: BRDF (BTDF) x cosine
 *   RADIAL_ANGULAR   radial_bins x angular_bins, row by radius: 1/(length^2 sr)
 *   DEPTH_ABSORBED   depth_bins: fraction absorbed per depth, 1/length, from the weights of all events, unscattered light's too.
 *                    Another estimate than LAYER_ABSORBED, which keeps the energy in balance: the sums agree within their errors
 *   DEPTH_FLUENCE    depth_bins: fluence integrated over the plane, which is the path length per depth; no unit. Where
 *                    sigma_t = 0 from the length of the flights (at angles up to 1e4 times the depth), elsewhere from
 *                    collisions. With max_order both depth quantities are those of light of the orders allowed: the event
 *                    at which a walk is cut counts in them
 *   ORDER            order_bins: fraction that leaves after 0, 1, ... scattering events
 *   PATH             path_bins: fraction per path length inside the slab, 1/length
 *   SWEEP            sweep_count: total (not only diffuse) reflectance, transmittance and absorption of each row */
enum {
  TYN_SLAB_LAYER_ABSORBED = 0,
  TYN_SLAB_RADIAL_REFLECTANCE = 1,
  TYN_SLAB_RADIAL_TRANSMITTANCE = 2,
  TYN_SLAB_ANGULAR_REFLECTANCE = 3,
  TYN_SLAB_ANGULAR_TRANSMITTANCE = 4,
  TYN_SLAB_RADIAL_ANGULAR_REFLECTANCE = 5,
  TYN_SLAB_RADIAL_ANGULAR_TRANSMITTANCE = 6,
  TYN_SLAB_DEPTH_ABSORBED = 7,
  TYN_SLAB_DEPTH_FLUENCE = 8,
  TYN_SLAB_ORDER_REFLECTANCE = 9,
  TYN_SLAB_ORDER_TRANSMITTANCE = 10,
  TYN_SLAB_PATH_REFLECTANCE = 11,
  TYN_SLAB_PATH_TRANSMITTANCE = 12,
  TYN_SLAB_SWEEP_REFLECTANCE = 13,
  TYN_SLAB_SWEEP_TRANSMITTANCE = 14,
  TYN_SLAB_SWEEP_ABSORBED = 15,
  TYN_SLAB_QUANTITY_COUNT = 16
};

/* Name of a quantity, such as "radial_reflectance"; NULL for no such quantity. */
TYN_API const char *tyn_slab_quantity_name(uint32_t quantity);

/* The results of a run. Owns its memory; needs neither context nor slab any more. Read-only: any thread. */
typedef struct TynSlabResult TynSlabResult;

/* Walks photons through a slab. Every channel has photons of its own, with the same random numbers. Every photon that is
 * started is finished. The same slab, options and photon count on the same device give the same bits; a longer run begins with
 * the photons of a shorter one.
 * `result`: receives a new object; NULL on failure, except CANCELLED, where it holds what was done (at least one batch).
 * Between launches of about 0.05 s (longer where batches of many channels or of very long walks take longer) progress is
 * reported, the clock is looked at, and the caller may cancel: walks that are started are finished first, which takes long
 * where they have millions of events (a thick white slab).
 * Precision: single, on the device. 1 - albedo is resolved to 2^-32; depths in a layer to 2^-24 of their value;
 * what interfaces reflect of light above 89.9 degrees to about 1 %.
 * Errors: INVALID_ARGUMENT (which field, its value, what is allowed; photons, seconds and target_error all 0; a half-space
 * whose last layer has 1 - albedo below 1e-7 and no max_order, whose walks would go on for ever; more than 2^22 tallies a
 * channel or 2^23 in all: the sum of bins, those of reflectance and transmittance each, those of depth in every layer),
 * OUT_OF_MEMORY, DEVICE, KERNEL_BUILD, CANCELLED. */
TYN_API TynStatus tyn_slab_simulate(TynContext *context, const TynSlab *slab, const TynSlabOptions *options,
                                    TynSlabResult **result);
TYN_API void tyn_slab_result_retain(TynSlabResult *result);
TYN_API void tyn_slab_result_release(TynSlabResult *result);

TYN_API TynStatus tyn_slab_result_run(const TynSlabResult *result, TynSlabRun *run);
/* `channel` < channel_count. */
TYN_API TynStatus tyn_slab_result_totals(const TynSlabResult *result, uint32_t channel, TynSlabTotals *totals);
/* Number of values of a quantity in one channel; 0 if it was not asked for or there is no such quantity. */
TYN_API size_t tyn_slab_result_count(const TynSlabResult *result, uint32_t quantity);
/* Copies a quantity: `count` must be tyn_slab_result_count. `standard_errors`: may be NULL. */
TYN_API TynStatus tyn_slab_result_read(const TynSlabResult *result, uint32_t quantity, uint32_t channel, double *values,
                                       double *standard_errors, size_t count);

#ifdef __cplusplus
}
#endif

#endif
