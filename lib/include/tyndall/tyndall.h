/* SPDX-License-Identifier: Apache-2.0 */
/*
 * Tyndall: subsurface scattering as a library.
 *
 *   context   a device, its queue and its compiled kernels                                    tyndall_base.h
 *   phase     phase functions, Lorenz-Mie scattering                                          tyndall_phase.h
 *   slab      exact transport in half-spaces and layered slabs, by Monte Carlo                tyndall_slab.h
 *   exact     the solvers and closed forms that the Monte Carlo is checked against            tyndall_exact.h
 *   bssrdf    models of subsurface light transport: profiles, albedos, sampling                 tyndall_bssrdf.h
 *   medium    coefficients, measured presets, albedo from colour
 *   scene     meshes, the media inside them, materials, lights, cameras; read-only once committed
 *   walk      the batch call: walks light through the inside of meshes
 *   renderer  a progressive path tracer over a scene
 * This header includes the others; records shared with OpenCL are in tyndall_types.h, interop in tyndall_cl.h.
 *
 * Conventions
 *   Lengths are in scene units (TynSceneOptions::metres_per_unit; glTF: 1), coefficients in 1/scene unit, angles in
 *   radians. Right-handed, Y up. RGB is linear with Rec.709 primaries. Strides are in bytes, 0 = tightly packed. Matrices
 *   are row-major.
 * Errors
 *   Every call that can fail returns a TynStatus. tyn_context_message says what was wrong, with which value, and what is
 *   allowed. A call that fails leaves the objects it was given as they were. Every call accepts NULL handles and answers
 *   TYN_ERROR_INVALID_ARGUMENT.
 * Option structs
 *   begin with their size and come from an inline function that sets the documented defaults: use it, so that a program
 *   compiled today works with a later library.
 * Ownership
 *   Handles are reference-counted: *_create returns one reference, *_retain adds one, *_release takes one away (NULL is
 *   allowed). A scene keeps its context alive, a renderer its scene. Arrays passed in are copied before a call returns.
 *   Release contexts before main returns: OpenCL implementations tear themselves down among the static destructors.
 * Threads
 *   Different contexts may be used at the same time. One context, with the scenes and renderers made from it, is used from
 *   one thread at a time. What was put into a committed scene never changes. Progress callbacks arrive on the calling thread.
 * Environment
 *   TYNDALL_DEVICE     device index or part of its name, when the options name none
 *   TYNDALL_CACHE_DIR  folder of compiled kernels and of tables (TYN_BSSRDF_EXACT); default: $XDG_CACHE_HOME/tyndall, then
 *                      ~/.cache/tyndall; empty: nothing is kept. PoCL keeps compiled kernels itself; ours go into this folder
 *                      only if one is named.
 */
#ifndef TYNDALL_H
#define TYNDALL_H

#include "tyndall_base.h"
#include "tyndall_bssrdf.h"
#include "tyndall_exact.h"
#include "tyndall_phase.h"
#include "tyndall_slab.h"
#include "tyndall_types.h"

#ifdef __cplusplus
extern "C" {
#endif

/* ---- Media ----------------------------------------------------------------------------------------------------------- */

/* A homogeneous participating medium. Its phase function is Henyey-Greenstein's of mean cosine g (g > 0 scatters forward)
 * unless `phase` names another. */
typedef struct TynMedium {
  size_t size;           /* sizeof(TynMedium) */
  const char *name;      /* copied; may be NULL */
  float sigma_a[3];      /* absorption, 1/scene unit, >= 0, finite */
  float sigma_s[3];      /* scattering, 1/scene unit, >= 0, finite */
  float g;               /* mean cosine, in (-1, 1); ignored if there is a `phase` */
  float ior;             /* index of refraction relative to outside, [1, 4]; 1: index-matched, light crosses unbent */
  const TynPhase *phase; /* copied, its table too; NULL (default): Henyey-Greenstein with g */
} TynMedium;

/* Defaults: no absorption, no scattering, g = 0, ior = 1. */
static inline TynMedium tyn_medium(void) {
  TynMedium medium;
  memset(&medium, 0, sizeof medium);
  medium.size = sizeof medium;
  medium.ior = 1.0f;
  return medium;
}

/* Measured media (Jensen, Marschner, Levoy, Hanrahan 2001, table in 1/mm): "apple", "chicken1", "chicken2", "cream",
 * "ketchup", "marble", "potato", "skimmilk", "skin1", "skin2", "spectralon", "wholemilk". The table holds reduced
 * coefficients sigma_s'; they are given back with g = 0. */
TYN_API uint32_t tyn_medium_preset_count(void);
/* Name of preset `index`, or NULL past the end. Static storage. */
TYN_API const char *tyn_medium_preset_name(uint32_t index);
/* Fills `medium` with preset `name` in 1/scene unit. `metres_per_unit` > 0. INVALID_ARGUMENT if there is none. */
TYN_API TynStatus tyn_medium_preset(const char *name, double metres_per_unit, TynMedium *medium);

/* Single-scattering albedo from a multiple-scattering colour (diffuse albedo of an index-matched half-space):
 * s = 4.09712 + 4.20863 C - sqrt(9.59217 + 41.6808 C + 17.7126 C^2), W = (1 - s^2) / (1 - g s^2)
 * (Kulla & Conty 2017, after van de Hulst 1980). A fit: with a dielectric boundary or g far from 0 the colour that comes
 * out is darker than `color`. color in [0, 1] (clamped), g in (-1, 1). */
TYN_API float tyn_albedo_from_color(float color, float g);
/* The inverse: C = (1 - s) (1 - 0.139 s) / (1 + 1.17 s), s = sqrt((1 - W) / (1 - W g)) (van de Hulst 1980). */
TYN_API float tyn_color_from_albedo(float albedo, float g);

/* Characteristic lengths of a medium per channel; INFINITY where there is none. Fractions are relative to
 * `reference_length` (e.g. a mesh's diagonal). */
typedef struct TynMediumDescription {
  float albedo[3];                       /* sigma_s / sigma_t; 0 for an empty medium */
  float diffuse_albedo[3];               /* colour of an index-matched half-space, tyn_color_from_albedo */
  double mean_free_path_mm[3];           /* 1 / sigma_t */
  double transport_mean_free_path_mm[3]; /* 1 / (sigma_a + sigma_s (1 - g)) */
  double diffusion_length_mm[3];         /* 1 / sqrt(3 sigma_a (sigma_a + sigma_s (1 - g))) */
  double mean_free_path_fraction[3];
  double transport_mean_free_path_fraction[3];
  double diffusion_length_fraction[3];
} TynMediumDescription;

/* `metres_per_unit` > 0, `reference_length` > 0 in scene units. */
TYN_API TynStatus tyn_medium_describe(const TynMedium *medium, double metres_per_unit, double reference_length,
                                      TynMediumDescription *description);

/* ---- Scene ----------------------------------------------------------------------------------------------------------- */

typedef struct TynScene TynScene;

typedef struct TynSceneOptions {
  size_t size;
  double metres_per_unit; /* > 0; default 1 */
} TynSceneOptions;

static inline TynSceneOptions tyn_scene_options(void) {
  TynSceneOptions options;
  memset(&options, 0, sizeof options);
  options.size = sizeof options;
  options.metres_per_unit = 1.0;
  return options;
}

/* Creates an empty scene. `options`: NULL for defaults. Things are added, then the scene is committed; after that it can
 * only be read (adding is INVALID_OPERATION). */
TYN_API TynStatus tyn_scene_create(TynContext *context, const TynSceneOptions *options, TynScene **scene);
TYN_API void tyn_scene_retain(TynScene *scene);
TYN_API void tyn_scene_release(TynScene *scene);
/* The scene's context (not retained); NULL for NULL. */
TYN_API TynContext *tyn_scene_context(const TynScene *scene);

/* Image formats; rows from top to bottom. */
enum {
  TYN_IMAGE_RGBA8_SRGB = 0,   /* 4 bytes a pixel; R, G, B with the sRGB curve, A linear */
  TYN_IMAGE_RGBA8_LINEAR = 1, /* 4 bytes a pixel */
  TYN_IMAGE_RGBA32F = 2       /* 4 floats a pixel, linear */
};

typedef struct TynImage {
  size_t size;
  const char *name;   /* copied; may be NULL */
  uint32_t width;     /* 1 .. 32768 */
  uint32_t height;    /* 1 .. 32768 */
  uint32_t format;    /* TYN_IMAGE_* */
  const void *pixels; /* copied; not NULL */
  size_t row_stride;  /* bytes; 0 = tightly packed */
} TynImage;

static inline TynImage tyn_image(void) {
  TynImage image;
  memset(&image, 0, sizeof image);
  image.size = sizeof image;
  return image;
}

/* Texture coordinate wrapping and filtering (glTF 2.0 samplers). */
enum { TYN_WRAP_REPEAT = 0, TYN_WRAP_CLAMP = 1, TYN_WRAP_MIRROR = 2 };
enum { TYN_FILTER_LINEAR = 0, TYN_FILTER_NEAREST = 1 };

/* A use of an image. The origin of uv is the upper left corner of the image, v grows downwards (glTF 2.0). */
typedef struct TynTexture {
  uint32_t image;  /* index from tyn_scene_add_image; TYN_NONE: no texture */
  uint32_t wrap_u; /* TYN_WRAP_* */
  uint32_t wrap_v;
  uint32_t filter;    /* TYN_FILTER_* */
  float transform[6]; /* u' = t[0] u + t[1] v + t[2], v' = t[3] u + t[4] v + t[5] (KHR_texture_transform) */
} TynTexture;

static inline TynTexture tyn_texture(void) {
  TynTexture texture;
  memset(&texture, 0, sizeof texture);
  texture.image = TYN_NONE;
  texture.transform[0] = 1.0f;
  texture.transform[4] = 1.0f;
  return texture;
}

/* What a surface does with light: metallic-roughness (glTF 2.0 appendix B) over an optional interior.
 * The dielectric part of the surface (fraction 1 - metallic) lets the fraction `transmission` of the light that its
 * interface transmits into the mesh's medium (a walk); the rest meets an opaque Lambertian base of colour base_color. */
typedef struct TynMaterial {
  size_t size;
  const char *name;    /* copied; may be NULL */
  float base_color[3]; /* [0, 1]; default 1 1 1 */
  float metallic;      /* [0, 1]; default 0 */
  float roughness;     /* perceptual, [0, 1]; GGX alpha = roughness^2; default 1; alpha < 0.001 is smooth */
  float ior; /* of the interface, [1, 4]; default 1.5. 1: no interface. A mesh with a medium: set both alike. */
  float transmission;          /* [0, 1]; default 0 (opaque); 1: everything that enters walks */
  float emission[3];           /* radiance, >= 0; default 0; emitted on the outside (both sides if double_sided) */
  float normal_scale;          /* of normal_texture; default 1 */
  uint32_t double_sided;       /* 0 or 1; no effect on a surface with an interior */
  uint32_t thin_walled;        /* 1: no interior; `transmission` passes straight through, tinted by base_color */
  float thin_scatter;          /* thin-walled: fraction of the transmitted light that is scattered, [0, 1]; default 0 */
  float thin_scatter_color[3]; /* thin-walled: diffuse colour of what is scattered; default 1 1 1 */
  float thin_scatter_anisotropy; /* thin-walled: (1 + g) / 2 goes through, (1 - g) / 2 comes back; default 0 */
  float multiscatter_color[3];   /* multiple-scattering colour, [0, 1]; [0] < 0 (default): the medium's own albedo.
                                    Otherwise the entry point's colour (times the two textures) sets the walk's albedo by
                                    tyn_albedo_from_color; sigma_t stays the medium's. */
  float scatter_strength;        /* [0, 1]; default 1; scales multiscatter_color */
  TynTexture base_color_texture; /* RGB, times base_color */
  TynTexture metallic_roughness_texture; /* B metallic, G roughness */
  TynTexture normal_texture;             /* tangent space */
  TynTexture emission_texture;           /* RGB, times emission */
  TynTexture transmission_texture;       /* R, times transmission */
  TynTexture multiscatter_color_texture; /* RGB, times multiscatter_color */
  TynTexture scatter_strength_texture;   /* A, times scatter_strength */
} TynMaterial;

static inline TynMaterial tyn_material(void) {
  TynMaterial material;
  memset(&material, 0, sizeof material);
  material.size = sizeof material;
  material.base_color[0] = material.base_color[1] = material.base_color[2] = 1.0f;
  material.roughness = 1.0f;
  material.ior = 1.5f;
  material.normal_scale = 1.0f;
  material.thin_scatter_color[0] = material.thin_scatter_color[1] = material.thin_scatter_color[2] = 1.0f;
  material.multiscatter_color[0] = -1.0f;
  material.scatter_strength = 1.0f;
  material.base_color_texture = material.metallic_roughness_texture = material.normal_texture = tyn_texture();
  material.emission_texture = material.transmission_texture = tyn_texture();
  material.multiscatter_color_texture = material.scatter_strength_texture = tyn_texture();
  return material;
}

/* A triangle mesh: one object, whose inside holds one medium. Positions may repeat (seams of normals and uv); vertices with
 * the same position are welded for the checks. An open or inconsistently oriented mesh, and closed parts that reach into one
 * another, are reported by tyn_scene_mesh_info and still render. */
typedef struct TynMesh {
  size_t size;
  const char *name;                   /* copied; may be NULL */
  const float *positions;             /* x y z, of size at most 1e10; not NULL. See tyn_walk for what walks need. */
  size_t position_stride;             /* bytes; 0 = 12 */
  uint32_t vertex_count;              /* >= 3 */
  const float *normals;               /* unit shading normals (normalized here); may be NULL */
  size_t normal_stride;               /* bytes; 0 = 12 */
  const float *uvs;                   /* may be NULL */
  size_t uv_stride;                   /* bytes; 0 = 8 */
  const uint32_t *indices;            /* 3 a triangle, each < vertex_count; not NULL */
  uint32_t triangle_count;            /* >= 1 */
  uint32_t medium;                    /* index of the medium inside; TYN_NONE: opaque */
  uint32_t material;                  /* index of the material; TYN_NONE: a default one */
  const uint32_t *triangle_materials; /* material of each triangle, triangle_count of them; NULL: `material` for all */
} TynMesh;

static inline TynMesh tyn_mesh(void) {
  TynMesh mesh;
  memset(&mesh, 0, sizeof mesh);
  mesh.size = sizeof mesh;
  mesh.medium = TYN_NONE;
  mesh.material = TYN_NONE;
  return mesh;
}

enum { TYN_LIGHT_POINT = 0, TYN_LIGHT_SPOT = 1, TYN_LIGHT_DIRECTIONAL = 2 };

/* A light without size (KHR_lights_punctual). */
typedef struct TynLight {
  size_t size;
  const char *name;
  uint32_t type;      /* TYN_LIGHT_* */
  float position[3];  /* point, spot */
  float direction[3]; /* spot, directional: unit, the direction the light travels in */
  float intensity[3]; /* point, spot: radiant intensity, power per steradian with lengths in scene units (irradiance at
                            distance d is intensity / d^2); directional: irradiance. >= 0, finite */
  float inner_cone;   /* spot: half angle at which the falloff begins, radians, [0, outer_cone) */
  float outer_cone;   /* spot: half angle at which it reaches 0, radians, (0, pi/2] */
} TynLight;

static inline TynLight tyn_light(void) {
  TynLight light;
  memset(&light, 0, sizeof light);
  light.size = sizeof light;
  light.direction[2] = -1.0f;
  light.intensity[0] = light.intensity[1] = light.intensity[2] = 1.0f;
  light.outer_cone = 0.78539816f;
  return light;
}

/* Light from infinitely far away. An image is latitude-longitude: its centre column looks along -Z (glTF's default view),
 * its top row along +Y, columns run to the right (+X). */
typedef struct TynEnvironment {
  size_t size;
  float radiance[3];           /* >= 0; constant radiance, or a factor on the image; default 0 0 0 */
  uint32_t image;              /* RGBA32F image, TYN_NONE (default): constant */
  float rotation;              /* radians about +Y, counter-clockwise seen from above */
  uint32_t hidden_from_camera; /* 1: camera rays that leave the scene see black (alpha 0 either way) */
} TynEnvironment;

static inline TynEnvironment tyn_environment(void) {
  TynEnvironment environment;
  memset(&environment, 0, sizeof environment);
  environment.size = sizeof environment;
  environment.image = TYN_NONE;
  return environment;
}

enum { TYN_CAMERA_PERSPECTIVE = 0, TYN_CAMERA_ORTHOGRAPHIC = 1 };

/* A camera looks along its local -Z with +Y up (glTF 2.0). */
typedef struct TynCamera {
  size_t size;
  const char *name;
  uint32_t type;               /* TYN_CAMERA_* */
  float world_from_camera[12]; /* row-major 3 x 4, rotation and translation */
  float yfov;                  /* perspective: vertical field of view, radians, (0, pi) */
  float ymag;                  /* orthographic: half the height of the view, scene units, > 0 */
  float
      aspect_ratio; /* width / height the camera was made for; 0: the film's. A film of another shape shows more, never less. */
  float znear; /* >= 0; nearer surfaces are not seen by camera rays */
} TynCamera;

static inline TynCamera tyn_camera(void) {
  TynCamera camera;
  memset(&camera, 0, sizeof camera);
  camera.size = sizeof camera;
  camera.world_from_camera[0] = camera.world_from_camera[5] = camera.world_from_camera[10] = 1.0f;
  camera.yfov = 0.69f;
  camera.ymag = 1.0f;
  return camera;
}

/* Each adds a copy and stores its index (index may be NULL). Errors: INVALID_ARGUMENT with the offending element and value,
 * INVALID_OPERATION after commit, OUT_OF_MEMORY. */
TYN_API TynStatus tyn_scene_add_image(TynScene *scene, const TynImage *image, uint32_t *index);
TYN_API TynStatus tyn_scene_add_medium(TynScene *scene, const TynMedium *medium, uint32_t *index);
TYN_API TynStatus tyn_scene_add_material(TynScene *scene, const TynMaterial *material, uint32_t *index);
TYN_API TynStatus tyn_scene_add_mesh(TynScene *scene, const TynMesh *mesh, uint32_t *index);
TYN_API TynStatus tyn_scene_add_light(TynScene *scene, const TynLight *light, uint32_t *index);
TYN_API TynStatus tyn_scene_add_camera(TynScene *scene, const TynCamera *camera, uint32_t *index);
/* Replaces the environment (a scene starts with a black one). */
TYN_API TynStatus tyn_scene_set_environment(TynScene *scene, const TynEnvironment *environment);
/* Removes all punctual lights; emissive triangles and the environment stay. */
TYN_API TynStatus tyn_scene_clear_lights(TynScene *scene);

/* Builds the acceleration structures, copies everything to the device and makes the scene read-only. A scene without a
 * mesh is INVALID_OPERATION. */
TYN_API TynStatus tyn_scene_commit(TynScene *scene);

/* What a scene holds. */
typedef struct TynSceneInfo {
  size_t size; /* set by the caller */
  uint32_t mesh_count, medium_count, material_count, image_count, light_count, camera_count;
  uint32_t emissive_triangle_count;
  uint32_t has_environment; /* 1 if the environment is not black */
  uint64_t triangle_count;
  double metres_per_unit;
  float lower[3], upper[3]; /* bounds of all meshes; lower > upper if there is none */
} TynSceneInfo;

/* What a mesh is. The checks are done when it is added: vertices of exactly equal position count as one.
 * Only the triangles of a mesh with a medium are turned: first those that disagree with most of their component, then, in
 * whole, each closed component whose signed volume is negative and that does not lie inside another one. One that faces
 * inwards inside another is a cavity and stays; what lies inside a turned one is turned where that is needed for cavities
 * to face inwards, and islands in them outwards. Without a medium the winding is the caller's and says which side is the
 * front, so that a room or a dome may face inwards; volume is then the absolute value. */
typedef struct TynMeshInfo {
  size_t size;      /* set by the caller */
  const char *name; /* valid as long as the scene; never NULL */
  uint32_t vertex_count, triangle_count;
  uint32_t welded_vertex_count;
  uint32_t closed;            /* 1: no boundary and no non-manifold edge */
  uint32_t boundary_edges;    /* edges with one triangle */
  uint32_t nonmanifold_edges; /* edges with more than two triangles */
  uint32_t
      degenerate_triangles; /* of zero area or with a repeated vertex: seen by rays only through rounding, where they close a gap */
  uint32_t duplicate_triangles;
  uint32_t components; /* connected over shared edges */
  uint32_t
      inverted_components; /* closed components whose triangles faced the wrong way and were turned; 0 without a medium */
  uint32_t
      turned_triangles; /* triangles whose winding disagreed with their neighbours' and was turned; 0 without a medium */
  uint32_t medium, material;
  double area;   /* scene units squared */
  double volume; /* scene units cubed; meaningful if closed and, without a medium, wound consistently */
  float lower[3], upper[3];
  uint32_t
      overlapping_components; /* closed components that were seen to reach into others or to touch them, in a few places
                                      of each, so 0 is no proof; 0 if the mesh is not closed or has no medium */
} TynMeshInfo;

TYN_API TynStatus tyn_scene_info(const TynScene *scene, TynSceneInfo *info);
TYN_API TynStatus tyn_scene_mesh_info(const TynScene *scene, uint32_t mesh, TynMeshInfo *info);
/* The names inside stay valid as long as the scene. Set `size` before the call. */
TYN_API TynStatus tyn_scene_medium(const TynScene *scene, uint32_t index, TynMedium *medium);
TYN_API TynStatus tyn_scene_camera(const TynScene *scene, uint32_t index, TynCamera *camera);

/* Nearest hit of each of `count` rays (any order; rays are independent). `mesh`: one mesh, or TYN_NONE for the whole scene.
 * Both sides of triangles are hit. The test is watertight: no ray passes between two triangles that share an edge
 * (Woop, Benthin, Wald 2013). */
TYN_API TynStatus tyn_intersect(TynScene *scene, uint32_t mesh, const TynRay *rays, size_t count, TynHit *hits);
/* Whether anything is hit: occluded[i] = 1 or 0. */
TYN_API TynStatus tyn_occluded(TynScene *scene, uint32_t mesh, const TynRay *rays, size_t count, uint32_t *occluded);

/* ---- Walks ----------------------------------------------------------------------------------------------------------- */

typedef struct TynWalkOptions {
  size_t size;
  uint64_t seed; /* any; default 0 */
  uint64_t
      first_path; /* path number of the first entry: splitting a batch changes nothing if this counts on; default 0 */
  uint32_t max_scatterings; /* 0 (default): no cap. Otherwise a walk ends there and the ledger says what was cut. */
  float roulette_threshold; /* walks whose largest channel falls below it play Russian roulette, (0, 1]; default 0.1 */
  uint32_t roulette_off;    /* 1: never; such a walk only ends by leaving (or at weight 0). Default 0 */
  TynProgress progress;     /* may be NULL */
  void *user;               /* passed to progress */
} TynWalkOptions;

static inline TynWalkOptions tyn_walk_options(void) {
  TynWalkOptions options;
  memset(&options, 0, sizeof options);
  options.size = sizeof options;
  options.roulette_threshold = 0.1f;
  return options;
}

/* Where the energy of a batch went, RGB sums of weights. In every channel
 * entered = reflected + escaped + absorbed + balance + capped + leaked + lost. */
typedef struct TynLedger {
  double entered[3];
  double reflected[3]; /* by the boundary, before entering (kind REFRACT) */
  double escaped[3];
  double absorbed[3]; /* by sigma_a, in expectation at every scattering */
  double balance
      [3]; /* what roulette and the balance heuristic over channels removed (> 0) or added (< 0): zero on average */
  double capped[3]; /* cut by max_scatterings, or trapped (TYN_WALK_CAPPED) */
  double leaked[3]; /* left through a hole, or as TYN_WALK_LEAKED says */
  double lost[3];   /* numerically */
  uint64_t walks, escaped_walks, absorbed_walks, capped_walks, leaked_walks, lost_walks, reflected_walks;
  uint64_t scatterings;
} TynLedger;

/* Walks `count` entries through the media of a committed scene. `exits`: `count` of them, in the order of the entries.
 * `ledger`: overwritten with this call's sums; may be NULL. `options`: NULL for defaults.
 * Channels: one flight serves all three; a channel is chosen in proportion to its throughput and the others are weighted by
 * the balance heuristic, so a weight never exceeds the number of channels times what entered.
 * Precision: single. Walks are right where the mean free path is at least 1e-5 of the mesh's largest absolute coordinate (at 1e-6,
 * escaped weights are off by several percent): move small dense things to the origin. Meshes should not be smaller than 1e-10.
 * Time: a walk in a white medium has 4 V sigma_s / S scatterings on average (V, S: the mesh's volume and surface), however large
 * that is, and a batch that has begun cannot be cancelled: set max_scatterings where sigma_s is extreme.
 * Errors: INVALID_ARGUMENT (which entry, which field, its value), INVALID_OPERATION, OUT_OF_MEMORY, DEVICE, KERNEL_BUILD,
 * CANCELLED (then only exits[0 .. ledger->walks) are valid). */
TYN_API TynStatus tyn_walk(TynScene *scene, const TynWalkOptions *options, const TynWalkEntry *entries, size_t count,
                           TynWalkExit *exits, TynLedger *ledger);

/* ---- Exit points of a BSSRDF ---------------------------------------------------------------------------------------- */

/* Draws a point of the surface where the light of each of `count` entries leaves, by the profile of a model: a channel's
 * integral over the mesh's surface, int f(x_o) R(|x_o - x_i|) dA, is estimated by f times its weight, R / pdf.
 * A radius is drawn as by tyn_bssrdf_sample, and probe rays along three axes (the normal and two tangents) look for the mesh's
 * surface at that distance from the axes through the entry (after King, Kulla, Conty, Fajardo 2013, "BSSRDF Importance
 * Sampling"). Of the points that they meet one is chosen, in proportion to R over the density with which all three find it. The
 * estimate is unbiased over a plane, and over any surface within the radius that all but 1/1000 of each channel's albedo is
 * in; of what is farther away, a part that only one axis sees from its side is left out. Over a plane the weights of one
 * channel are as those of tyn_bssrdf_sample.
 * `bssrdf`: of the scene's context, and not of what a slab transmits. `scene`: committed; may be without media.
 * `seed`, `first`: exit i is a function of seed, first + i + the entry's path, and the entry.
 * `entries`: not NULL, `count` of them. `exits`: not NULL, `count`, in the order of the entries.
 * `weights`: channel_count x count, value [channel * count + i], >= 0; may be NULL.
 * Errors: INVALID_ARGUMENT (which entry, which field, its value), INVALID_OPERATION (the scene is not committed),
 * OUT_OF_MEMORY, DEVICE, KERNEL_BUILD. */
TYN_API TynStatus tyn_bssrdf_sample_exits(TynBssrdf *bssrdf, TynScene *scene, uint64_t seed, uint64_t first,
                                          const TynBssrdfEntry *entries, size_t count, TynBssrdfExit *exits,
                                          float *weights);

/* ---- Renderer -------------------------------------------------------------------------------------------------------- */

typedef struct TynRenderer TynRenderer;

/* How light that was scattered inside a medium leaves it. What was not scattered keeps its refracted direction either way, so
 * clear glass stays clear.
 * DIFFUSE: the normalized-Fresnel cosine lobe (1 - F(cos)) cos / (pi c) about the shading normal. Energy is exact; angles are
 * those of light that is diffuse inside the boundary, an approximation. Little noise.
 * DIELECTRIC: the walk's own refracted direction, exact. Point, spot and directional lights, which such a direction never
 * meets, still go through the diffuse lobe. More noise. */
enum {
  TYN_EXIT_DIFFUSE = 0, /* default */
  TYN_EXIT_DIELECTRIC = 1
};

typedef struct TynRenderOptions {
  size_t size;
  uint32_t width, height; /* pixels, 1 .. 32768; default 640 x 480 */
  TynCamera camera;       /* default: tyn_camera(); see tyn_scene_frame */
  uint64_t seed;          /* default 0 */
  uint32_t
      max_bounces; /* surface interactions of a path, >= 1; default 64; a walk counts as one. Roulette ends most before. */
  uint32_t exit;   /* TYN_EXIT_* */
  uint32_t bssrdf; /* TYN_BSSRDF_*: a model in place of walks; TYN_NONE (default): walks. See below. */
} TynRenderOptions;

/* With a BSSRDF model, light that enters a medium leaves where tyn_bssrdf_sample_exits would draw it, by the profile of the
 * medium as a half-space, its boundary and phase function included, and goes on by the diffuse lobe. An approximation, for
 * surfaces that are flat over a few mean free paths; with less noise a sample than walks, and on CPUs not faster than they
 * are. An albedo of the entry point's own (multiscatter_color) counts: profiles are prepared for a range of albedos by the
 * first tyn_renderer_run, in up to some seconds a medium (EXACT makes tables; they count in neither its seconds nor those
 * of its budget, and its progress hears 0 meanwhile), and blended. EXACT has the right totals from every side, with the
 * profile of perpendicular light. TYN_EXIT_DIELECTRIC, the model GAUSSIANS, and a mesh's medium with a channel without
 * extinction are INVALID_ARGUMENT. The ledger: absorbed is what the model keeps of light on a plane (negative where a
 * model's albedo exceeds 1), balance the difference to what was found; light that comes from inside a mesh, through a hole,
 * is leaked. */
static inline TynRenderOptions tyn_render_options(void) {
  TynRenderOptions options;
  memset(&options, 0, sizeof options);
  options.size = sizeof options;
  options.width = 640;
  options.height = 480;
  options.camera = tyn_camera();
  options.max_bounces = 64;
  options.bssrdf = TYN_NONE;
  return options;
}

/* Fills `camera` with a view of the whole scene: from the front, slightly above, 30 degrees field of view, for a film of
 * `aspect_ratio` = width / height > 0. */
TYN_API TynStatus tyn_scene_frame(const TynScene *scene, float aspect_ratio, TynCamera *camera);

/* Creates a renderer with an empty film on a committed scene. */
TYN_API TynStatus tyn_renderer_create(TynScene *scene, const TynRenderOptions *options, TynRenderer **renderer);
TYN_API void tyn_renderer_retain(TynRenderer *renderer);
TYN_API void tyn_renderer_release(TynRenderer *renderer);
/* The renderer's scene (not retained); NULL for NULL. */
TYN_API TynScene *tyn_renderer_scene(const TynRenderer *renderer);

/* When to stop: whichever comes first. The error is the mean over the pixels of stderr / (value + 0.01 x mean value) of
 * beauty's luminance; it is looked at at fixed sample counts from 16 on, so that where a render stops depends on nothing but
 * its samples. */
typedef struct TynRenderBudget {
  size_t size;
  uint32_t samples;     /* samples a pixel to add; 0: no limit; default 64 */
  double seconds;       /* wall-clock; 0: no limit; checked between passes */
  double target_error;  /* 0: none */
  TynProgress progress; /* may be NULL */
  void *user;
} TynRenderBudget;

static inline TynRenderBudget tyn_render_budget(void) {
  TynRenderBudget budget;
  memset(&budget, 0, sizeof budget);
  budget.size = sizeof budget;
  budget.samples = 64;
  return budget;
}

/* Adds samples to the film until the budget is spent; call again to go on. All three limits 0 is INVALID_ARGUMENT.
 * CANCELLED leaves a valid film with fewer samples. Same scene, options and number of samples: the same bits, however the
 * samples were split over calls. */
TYN_API TynStatus tyn_renderer_run(TynRenderer *renderer, const TynRenderBudget *budget);

/* Layers of the film. beauty = subsurface + specular + diffuse + emission, by the first thing the path did. */
enum {
  TYN_LAYER_BEAUTY = 0,     /* R G B A: radiance, and the fraction of camera rays that hit something */
  TYN_LAYER_SUBSURFACE = 1, /* R G B: paths whose first event went through a medium */
  TYN_LAYER_SPECULAR = 2,   /* R G B: first reflected by an interface or a metal, or passed a thin wall */
  TYN_LAYER_DIFFUSE = 3,    /* R G B: first reflected by an opaque or thin-walled diffuse surface */
  TYN_LAYER_EMISSION = 4,   /* R G B: lights, emissive surfaces and environment seen directly */
  TYN_LAYER_ALBEDO = 5,     /* R G B: colour of the first surface (base colour or multiple-scattering colour) */
  TYN_LAYER_NORMAL = 6,     /* X Y Z: first shading normal, world space, mean over samples */
  TYN_LAYER_DEPTH = 7,      /* Z: mean distance along the view axis of the samples that hit; INFINITY where none did */
  TYN_LAYER_SAMPLES = 8,    /* Y: number of samples */
  TYN_LAYER_VARIANCE = 9,   /* R G B: variance of the mean of beauty (squared standard error) */
  TYN_LAYER_COUNT = 10
};

/* Name ("beauty", "subsurface", ...) and number of channels of a layer; NULL and 0 for no such layer. */
TYN_API const char *tyn_layer_name(uint32_t layer);
TYN_API uint32_t tyn_layer_channels(uint32_t layer);

/* Copies a layer, width x height x channels floats, rows from top to bottom. `count`: floats that `pixels` has room for. */
TYN_API TynStatus tyn_renderer_read(TynRenderer *renderer, uint32_t layer, float *pixels, size_t count);

typedef struct TynRenderStats {
  size_t size; /* set by the caller */
  uint32_t width, height;
  uint32_t samples; /* a pixel, so far */
  double seconds;   /* spent in tyn_renderer_run */
  double error;     /* as in target_error; 0 before 2 samples */
  uint64_t paths;
  uint64_t nonfinite_paths; /* whose contribution was not finite and was left out; 0 unless there is a defect */
  uint64_t seed;
  TynLedger ledger; /* of all walks */
  /* Where `seconds` went: time on the device, in seconds >= 0, by kind of kernel. What is missing to `seconds` is the host's:
   * compiling kernels, copying, waiting. All 0 if it is not known, because the caller's queue (tyndall_cl.h) was made without
   * CL_QUEUE_PROFILING_ENABLE; otherwise seconds_rays > 0 once there is a path. */
  double seconds_rays;    /* camera rays made; nearest hits of all paths; shadow rays from surfaces */
  double seconds_walks;   /* walks inside media, and their ledger; 0 in a scene without media */
  double seconds_exits;   /* light samples and next ray where a walk left its medium, the shadow rays there included */
  double seconds_shading; /* materials, light samples and next ray at surfaces; adding paths to the film */
} TynRenderStats;

TYN_API TynStatus tyn_renderer_stats(TynRenderer *renderer, TynRenderStats *stats);

#ifdef __cplusplus
}
#endif

#endif
