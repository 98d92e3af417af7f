// SPDX-License-Identifier: Apache-2.0
// The records that the renderer's host code and its kernels share: one definition, 4-byte scalars only.
#ifndef TYN_SHARED_RENDER_H
#define TYN_SHARED_RENDER_H

#include "shared.h"

// The enumerations of tyndall.h that records carry, for kernels, which cannot include it. The ABI fixes their values.
#ifdef __OPENCL_VERSION__
enum { TYN_IMAGE_RGBA8_SRGB = 0, TYN_IMAGE_RGBA8_LINEAR = 1, TYN_IMAGE_RGBA32F = 2 };
enum { TYN_WRAP_REPEAT = 0, TYN_WRAP_CLAMP = 1, TYN_WRAP_MIRROR = 2 };
enum { TYN_FILTER_LINEAR = 0, TYN_FILTER_NEAREST = 1 };
enum { TYN_LIGHT_POINT = 0, TYN_LIGHT_SPOT = 1, TYN_LIGHT_DIRECTIONAL = 2 };
enum { TYN_CAMERA_PERSPECTIVE = 0, TYN_CAMERA_ORTHOGRAPHIC = 1 };
enum { TYN_EXIT_DIFFUSE = 0, TYN_EXIT_DIELECTRIC = 1 };
#endif

// ---- Materials and textures ---------------------------------------------------------------------------------------------

typedef struct TynImageRecord {
  uint32_t width, height;
  uint32_t format; // TYN_IMAGE_*
  uint32_t first;  // first texel: in the buffer of bytes for the 8-bit formats, else in the one of floats
} TynImageRecord;  // 16 bytes

typedef struct TynTextureRecord {
  uint32_t image; // TYN_NONE never: unused textures have no record
  uint32_t wrap_u, wrap_v;
  uint32_t filter;
  float transform[6];
} TynTextureRecord; // 40 bytes

// Places in TynMaterialRecord::textures.
#define TYN_TEXTURE_BASE_COLOR 0
#define TYN_TEXTURE_METALLIC_ROUGHNESS 1
#define TYN_TEXTURE_NORMAL 2
#define TYN_TEXTURE_EMISSION 3
#define TYN_TEXTURE_TRANSMISSION 4
#define TYN_TEXTURE_MULTISCATTER 5
#define TYN_TEXTURE_STRENGTH 6
#define TYN_TEXTURE_COUNT 7

#define TYN_MATERIAL_DOUBLE_SIDED 1u
#define TYN_MATERIAL_THIN 2u

typedef struct TynMaterialRecord {
  float base_color[3];
  float metallic;
  float emission[3];
  float roughness;
  float multiscatter_color[3]; // [0] < 0: the medium's own
  float transmission;
  float thin_color[3];
  float thin_scatter;
  float thin_forward; // fraction of the scattered light that goes through
  float ior;
  float transmittance;    // mean of 1 - F over cosine-distributed light from outside
  float emission_density; // chance per area that a light sample falls on this material's triangles; 0: never
  float normal_scale;
  float scatter_strength;
  uint32_t flags;                       // TYN_MATERIAL_*
  uint32_t textures[TYN_TEXTURE_COUNT]; // TynTextureRecord, or TYN_NONE
} TynMaterialRecord;                    // 120 bytes

// What the renderer knows of a medium beyond TynMediumRecord.
typedef struct TynRenderMedium {
  float color[3];      // diffuse albedo of a half-space, for the albedo layer
  float transmittance; // as in TynMaterialRecord, for the medium's index
} TynRenderMedium;     // 16 bytes

// ---- Lights -------------------------------------------------------------------------------------------------------------

#define TYN_EMITTER_LIGHT 0u
#define TYN_EMITTER_TRIANGLE 1u
#define TYN_EMITTER_ENVIRONMENT 2u

// One row of the alias table from which light samples are drawn (Walker 1977): the row is kept if a uniform number is
// below `threshold`, else row `alias` is taken.
typedef struct TynEmitterRecord {
  uint32_t kind;  // TYN_EMITTER_*
  uint32_t index; // light, or scene-wide triangle
  float threshold;
  uint32_t alias;
  float probability; // of this emitter
} TynEmitterRecord;  // 20 bytes

typedef struct TynLightRecord {
  float position[3];
  uint32_t type; // TYN_LIGHT_*
  float direction[3];
  float angle_scale; // spot: attenuation = clamp(cos * scale + offset)^2
  float intensity[3];
  float angle_offset;
} TynLightRecord; // 48 bytes

// One texel of the environment's alias table.
typedef struct TynEnvironmentTexel {
  float threshold;
  uint32_t alias;
  float density;       // of samples over the unit square of texture coordinates
} TynEnvironmentTexel; // 12 bytes

// ---- Camera and parameters ----------------------------------------------------------------------------------------------

typedef struct TynCameraRecord {
  float world_from_camera[12];
  float half_width, half_height; // of the view at distance 1 (perspective), or everywhere (orthographic)
  float znear;
  uint32_t type;   // TYN_CAMERA_*
} TynCameraRecord; // 64 bytes

// How direct light is found. The first is what users get; the others exist so that tests can compare the three.
#define TYN_STRATEGY_MIS 0u    // both ways, weighted by the power heuristic
#define TYN_STRATEGY_LIGHTS 1u // by sampling lights alone, where that is possible
#define TYN_STRATEGY_LOBES 2u  // by following paths alone, where that is possible

typedef struct TynRenderParameters {
  uint32_t seed[2]; // low, high word
  uint32_t width, height;
  uint32_t first_pixel, pixel_count;   // of this pass
  uint32_t first_sample, sample_count; // of this pass, the same for each of its pixels
  uint32_t max_bounces;
  uint32_t exit;     // TYN_EXIT_*
  uint32_t strategy; // TYN_STRATEGY_*
  uint32_t emitter_count;
  float environment[3];                   // radiance, or factor on the image
  uint32_t environment_image;             // TynImageRecord, or TYN_NONE
  float environment_cos, environment_sin; // of the rotation
  float environment_probability;          // that a light sample is one of the environment
  uint32_t environment_hidden;
} TynRenderParameters; // 80 bytes

// ---- Paths --------------------------------------------------------------------------------------------------------------

// What a path did first decides the layer that all its light goes to. Also places in TynPathResult::light.
#define TYN_EVENT_SUBSURFACE 0u
#define TYN_EVENT_SPECULAR 1u
#define TYN_EVENT_DIFFUSE 2u
#define TYN_EVENT_NONE 3u // light seen directly: emission
#define TYN_EVENT_COUNT 4u

typedef struct TynPathState {
  float origin[3];
  float t_min;
  float direction[3];
  float pdf; // density per solid angle with which `direction` was drawn; 0: no light sample could have found it
  float throughput[3];
  uint32_t bounces;
  float t, u, v; // nearest hit along the ray
  uint32_t triangle;
  uint32_t event; // TYN_EVENT_*
  float cos_axis; // camera rays: distance along the view axis per distance along the ray
  uint32_t reserved[2];
} TynPathState; // 80 bytes

// What the film receives of a path.
typedef struct TynPathResult {
  float light[TYN_EVENT_COUNT][3];
  float albedo[3];
  float depth; // INFINITY: nothing was hit
  float normal[3];
  uint32_t reserved;
} TynPathResult; // 80 bytes

// Light that arrives if nothing is in the way.
typedef struct TynShadowRay {
  float origin[3];
  float t_max;
  float direction[3];
  uint32_t path;
  float first[3]; // for layer `first_event`
  uint32_t first_event;
  float second[3]; // for layer `second_event`
  uint32_t second_event;
} TynShadowRay; // 64 bytes

// Places in the buffer of counters.
#define TYN_COUNT_NEXT 0    // paths that go on
#define TYN_COUNT_WALKS 1   // walks to do
#define TYN_COUNT_SHADOWS 2 // shadow rays to trace
#define TYN_COUNT_BAD 3     // paths whose light is not finite
#define TYN_COUNTERS 4

// ---- Film ---------------------------------------------------------------------------------------------------------------
// One plane of width x height floats each; means are over a pixel's samples.
#define TYN_PLANE_BEAUTY 0    // 3 planes: mean
#define TYN_PLANE_SPREAD 3    // 3 planes: sum of squared deviations from the mean (Welford 1962)
#define TYN_PLANE_LUMINANCE 6 // the same of beauty's luminance
#define TYN_PLANE_LIGHT 7     // 3 planes for each event: means
#define TYN_PLANE_ALPHA 19    // mean
#define TYN_PLANE_ALBEDO 20   // 3 planes: mean over all samples
#define TYN_PLANE_NORMAL 23   // 3 planes: mean over all samples
#define TYN_PLANE_DEPTH 26    // mean over the samples that hit
#define TYN_PLANE_HITS 27     // number of samples that hit
#define TYN_PLANE_SAMPLES 28  // number of samples
#define TYN_PLANE_COUNT 29

// ---- Ledger -------------------------------------------------------------------------------------------------------------
// Sums of weights in units of 2^-32, so that they are exact and do not depend on the order of the walks. Words: low, high.
#define TYN_LEDGER_ENTERED 0
#define TYN_LEDGER_REFLECTED 3
#define TYN_LEDGER_ESCAPED 6
#define TYN_LEDGER_ABSORBED 9
#define TYN_LEDGER_BALANCE 12
#define TYN_LEDGER_CAPPED 15
#define TYN_LEDGER_LEAKED 18
#define TYN_LEDGER_LOST 21
#define TYN_LEDGER_SCATTERINGS 24 // in units
#define TYN_LEDGER_WALKS 25       // in units; one for each TYN_WALK_*
#define TYN_LEDGER_COUNT 31
#define TYN_LEDGER_SLICE 256 // walks a work-item

#endif
