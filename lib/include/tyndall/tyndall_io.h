/* SPDX-License-Identifier: Apache-2.0 */
/*
 * Tyndall's files: glTF in, OpenEXR and PNG out. A library of its own (tyndall-io), so that a renderer that embeds Tyndall
 * does not pull in tinygltf and OpenEXR. Messages of failing calls are in tyn_context_message of the scene's context.
 */
#ifndef TYNDALL_IO_H
#define TYNDALL_IO_H

#include "tyndall.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Receives one line for each thing in a file that was ignored, repaired or doubtful. */
typedef void (*TynWarning)(void *user, const char *message);

/* Turns the dielectric materials of a model without scattering into a medium. */
typedef struct TynMediumAssignment {
  const char *material; /* name of a material in the file; NULL or "ALL": every one that is not fully metallic */
  const char *medium;   /* a name of tyn_medium_preset_name */
} TynMediumAssignment;

typedef struct TynGltfOptions {
  size_t size;
  const TynMediumAssignment *assignments; /* assignment_count of them; the last that matches wins; may be NULL if 0 */
  size_t assignment_count;
  uint32_t skip_lights;      /* 1: punctual lights of the file are left out */
  uint64_t max_file_bytes;   /* larger files, buffers and images are refused; default 1 GiB */
  uint64_t max_triangles;    /* default 100 million */
  uint64_t max_image_pixels; /* default 256 million */
  TynWarning warning;        /* may be NULL */
  void *user;
} TynGltfOptions;

static inline TynGltfOptions tyn_gltf_options(void) {
  TynGltfOptions options;
  memset(&options, 0, sizeof options);
  options.size = sizeof options;
  options.max_file_bytes = (uint64_t)1 << 30;
  options.max_triangles = 100000000u;
  options.max_image_pixels = (uint64_t)1 << 28;
  return options;
}

/* Adds the default scene of a glTF 2.0 file (.gltf or .glb) to `scene`, which must not be committed and must have
 * metres_per_unit 1: meshes in world space, media, materials, textures, lights, cameras.
 * Errors: FILE (cannot be read), FORMAT (what is wrong, with the JSON path of the element, or the unsupported required
 * extension), INVALID_ARGUMENT (an unknown preset, say), OUT_OF_MEMORY. On failure nothing was added. */
TYN_API TynStatus tyn_gltf_load(TynScene *scene, const char *path, const TynGltfOptions *options);

/* Adds the image of an OpenEXR file (R G B of its first part) as an RGBA32F image; stores its index. */
TYN_API TynStatus tyn_exr_load(TynScene *scene, const char *path, uint32_t *image);

/* A name and a value written into the header of an image file. */
typedef struct TynAttribute {
  const char *name;
  const char *value;
} TynAttribute;

/* Writes all layers of a renderer's film as one OpenEXR file: R G B A (beauty) and layer.channel for the others, 32-bit float,
 * ZIP, with chromaticities, and attributes for software, seed, samples, seconds, device and `attributes` (may be NULL if
 * count is 0). The file appears under its name only when it is complete. Errors: FILE. */
TYN_API TynStatus tyn_exr_write(TynRenderer *renderer, const char *path, const TynAttribute *attributes, size_t count);

enum {
  TYN_TONE_SRGB = 0, /* clamp to [0, 1] and apply the sRGB curve */
  TYN_TONE_ACES = 1  /* the rational fit of Narkowicz 2015 to the ACES curve, then sRGB */
};

typedef struct TynPngOptions {
  size_t size;
  float exposure;       /* stops, added before the tone curve; default 0 */
  uint32_t tone;        /* TYN_TONE_*; default TYN_TONE_SRGB */
  uint32_t layer;       /* TYN_LAYER_*; default beauty */
  uint32_t transparent; /* 1: write beauty's alpha; default 0 */
} TynPngOptions;

static inline TynPngOptions tyn_png_options(void) {
  TynPngOptions options;
  memset(&options, 0, sizeof options);
  options.size = sizeof options;
  return options;
}

/* Writes one layer as an 8-bit PNG preview; names the tone mapping in its text chunks. Errors: FILE. */
TYN_API TynStatus tyn_png_write(TynRenderer *renderer, const char *path, const TynPngOptions *options);

#ifdef __cplusplus
}
#endif

#endif
