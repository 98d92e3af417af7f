/* SPDX-License-Identifier: Apache-2.0 */
/*
 * Tyndall: the records of the batch calls. One definition serves the C API and the OpenCL kernels: 4-byte scalars only,
 * so that host and device agree on every offset.
 *
 * Lengths are in scene units, coefficients in 1/scene unit. Directions have unit length; a direction that is not within
 * 1e-3 of unit length is an invalid argument. "Outside" is the side that the geometric normal points to (counter-clockwise
 * winding seen from outside). RGB is linear, Rec.709 primaries.
 */
#ifndef TYNDALL_TYPES_H
#define TYNDALL_TYPES_H

#ifdef __OPENCL_VERSION__
typedef int int32_t;
typedef uint uint32_t;
#else
#include <stdint.h>
#endif

/* "No such index": in TynHit::mesh a miss, in a material no texture, in a mesh no medium. */
#define TYN_NONE 0xffffffffu

/* A ray of tyn_intersect and tyn_occluded. It covers origin + t * direction for t in [t_min, t_max]. */
typedef struct TynRay {
  float origin[3];
  float t_min; /* >= 0 */
  float direction[3];
  float t_max; /* > t_min; INFINITY is allowed */
} TynRay;

/* The nearest intersection of a ray, or none. Equal distances go to the lowest mesh, then the lowest triangle. */
typedef struct TynHit {
  float t;           /* distance in units of the ray's direction; INFINITY at a miss */
  float u, v;        /* barycentric coordinates: point = (1-u-v) p0 + u p1 + v p2 */
  uint32_t mesh;     /* TYN_NONE at a miss */
  uint32_t triangle; /* index within the mesh */
  float normal[3];   /* unit geometric normal, outside, whichever side was hit */
} TynHit;

/* How a walk begins. */
enum {
  TYN_ENTRY_INSIDE = 0,  /* `direction` points into the medium: the walk starts along it */
  TYN_ENTRY_REFRACT = 1, /* `direction` travels towards the surface from outside: Fresnel reflection is taken off the
                            weight (ledger: reflected), the rest is refracted */
  TYN_ENTRY_COSINE = 2   /* `direction` is ignored: a cosine-distributed direction about the inward normal is drawn */
};

/* What a walk starts from: 96 bytes. */
typedef struct TynWalkEntry {
  float position[3];  /* on the triangle (kinds REFRACT, COSINE), or anywhere inside (INSIDE with triangle TYN_NONE) */
  uint32_t kind;      /* TYN_ENTRY_* */
  float direction[3]; /* unit; see `kind` */
  uint32_t mesh;      /* mesh whose inside is walked; must have a medium, here or through `medium` */
  float weight[3];    /* RGB weight that enters, >= 0; usually 1 1 1 */
  uint32_t triangle;  /* triangle within the mesh on which `position` lies; TYN_NONE: in the interior (kind INSIDE) */
  float
      albedo[3]; /* single-scattering albedo in [0, 1] for this walk (a texture's value); albedo[0] < 0: the medium's */
  uint32_t medium;    /* index of the medium; TYN_NONE: the mesh's */
  float sigma_t[3];   /* extinction for this walk, 1/scene unit, >= 0; sigma_t[0] < 0: the medium's */
  uint32_t reserved;  /* 0 */
  float roughness;    /* GGX alpha of the boundary seen from inside, [0, 1]; 0 smooth; ignored when index-matched */
  uint32_t path[2];   /* low and high word added to the call's first_path + index: chooses the random numbers; 0 0 */
  uint32_t reserved2; /* 0 */
} TynWalkEntry;

/* How a walk ended.
 * LEAKED in a closed mesh: with ior > 1, after a reflection at the very edge of two triangles, where rounding decides what is
 * inside; rare.
 * CAPPED: it reached the caller's max_scatterings, or it is trapped: the boundary reflected it 65536 times without a scattering
 * event (4096 times in a medium without extinction). */
enum {
  TYN_WALK_ESCAPED = 0,  /* left through the boundary: position, direction and weight are set */
  TYN_WALK_ABSORBED = 1, /* ended by roulette, or its weight reached exactly 0 */
  TYN_WALK_CAPPED = 2,   /* cut short */
  TYN_WALK_LEAKED = 3,   /* left the bounds of its mesh without crossing a triangle: a hole */
  TYN_WALK_LOST = 4,     /* a number became NaN or infinite: reported, never silently dropped */
  TYN_WALK_REFLECTED = 5 /* kind REFRACT: nothing was transmitted */
};

/* Where and how a walk ended: 96 bytes. Unless the status is ESCAPED, position and direction are the last known ones and
 * weight is what was left when the walk ended. */
typedef struct TynWalkExit {
  float position[3];
  uint32_t status;      /* TYN_WALK_* */
  float direction[3];   /* unit, pointing outside */
  uint32_t triangle;    /* triangle of the mesh that was crossed; TYN_NONE if none */
  float weight[3];      /* RGB weight that leaves; per walk at most (number of channels) x the weight that entered */
  uint32_t scatterings; /* number of scattering events */
  float geometric_normal[3]; /* unit, outside */
  float path_length;         /* total length travelled inside, scene units */
  float shading_normal[3];   /* unit, interpolated vertex normals (the geometric normal if the mesh has none) */
  float u;                   /* barycentric coordinates on `triangle`, as in TynHit */
  float uv[2];               /* interpolated texture coordinates; 0 0 if the mesh has none */
  float v;
  uint32_t reserved; /* 0 */
} TynWalkExit;

/* Where light gets into a mesh, for tyn_bssrdf_sample_exits: 48 bytes. */
typedef struct TynBssrdfEntry {
  float position[3];     /* on the surface of the mesh; what is nearer to it than its rounding does not matter */
  uint32_t mesh;         /* whose surface the light leaves through, too */
  float normal[3];       /* unit, of the surface there, outside */
  uint32_t reserved;     /* 0 */
  uint32_t path[2];      /* low and high word added to the call's first + index: chooses the random numbers; 0 0 */
  uint32_t reserved2[2]; /* 0 */
} TynBssrdfEntry;

/* What was found of an entry. */
enum {
  TYN_BSSRDF_EXIT_FOUND = 0, /* a point of the mesh's surface */
  TYN_BSSRDF_EXIT_NONE = 1, /* there is no surface where it was looked for, or no channel has an albedo: weights and all
                                members but distance, which is the radius that was drawn, are 0, triangle is TYN_NONE */
  TYN_BSSRDF_EXIT_LOST =
      2 /* tyn_bssrdf_sample_exits_cl only: a bad mesh index, or a number that is not finite; as NONE */
};

/* Where light that got in leaves: 80 bytes. */
typedef struct TynBssrdfExit {
  float position[3];         /* on `triangle` */
  uint32_t status;           /* TYN_BSSRDF_EXIT_* */
  float geometric_normal[3]; /* unit, outside */
  uint32_t triangle;         /* within the mesh */
  float shading_normal[3];   /* unit, interpolated vertex normals (the geometric normal if the mesh has none) */
  uint32_t hits;             /* points of the surface that were found, of which this is one, >= 1 */
  float u, v;                /* barycentric coordinates on `triangle`, as in TynHit */
  float uv[2];               /* interpolated texture coordinates; 0 0 if the mesh has none */
  float distance;            /* from the entry, straight, scene units */
  float pdf; /* density per area with which the point is found, 1/length^2, times its chance among the hits; > 0 */
  uint32_t reserved[2]; /* 0 */
} TynBssrdfExit;

/* Phase functions p(cos), 1/sr; see TynPhase in tyndall_phase.h. */
enum {
  TYN_PHASE_ISOTROPIC = 0,         /* 1 / (4 pi) */
  TYN_PHASE_RAYLEIGH = 1,          /* 3 / (16 pi) (1 + cos^2) (Rayleigh 1871) */
  TYN_PHASE_HENYEY_GREENSTEIN = 2, /* (1 - g^2) / (4 pi (1 + g^2 - 2 g cos)^(3/2)) (Henyey & Greenstein 1941) */
  TYN_PHASE_TWO_LOBE = 3,          /* weight HG(g) + (1 - weight) HG(g2) */
  TYN_PHASE_DRAINE = 4,            /* HG(g) (1 + alpha cos^2) / (1 + alpha (1 + 2 g^2) / 3) (Draine 2003, eq. 4) */
  TYN_PHASE_TABULATED = 5,         /* linear in cos between the entries of a table, which is normalized */
  TYN_PHASE_KIND_COUNT = 6
};

/* Models of the BSSRDF: see tyndall_bssrdf.h. */
enum {
  TYN_BSSRDF_STANDARD_DIPOLE = 0,       /* Jensen, Marschner, Levoy, Hanrahan 2001 */
  TYN_BSSRDF_BETTER_DIPOLE = 1,         /* d'Eon 2012; without single scattering */
  TYN_BSSRDF_PHOTON_BEAM_DIFFUSION = 2, /* Habel, Christensen, Jarosz 2013; single scattering included */
  TYN_BSSRDF_MULTIPOLE = 3,             /* Donner & Jensen 2005; 1 .. 64 layers */
  TYN_BSSRDF_NORMALIZED_DIFFUSION = 4,  /* Christensen & Burley 2015 */
  TYN_BSSRDF_GAUSSIANS = 5,             /* the caller's */
  TYN_BSSRDF_SINGLE_SCATTERING = 6,     /* Hanrahan & Krueger 1993; the top layer's alone */
  TYN_BSSRDF_QUANTIZED_DIFFUSION = 7,   /* d'Eon & Irving 2011; without single scattering */
  TYN_BSSRDF_DIRECTIONAL_DIPOLE = 8,    /* Frisvad, Hachisuka, Kjeldsen 2014; without single scattering */
  TYN_BSSRDF_EXACT = 9,                 /* tables of the slab engine's walks */
  TYN_BSSRDF_MODEL_COUNT = 10
};

/* Light that arrives at a point of a surface and leaves at another, for tyn_bssrdf_evaluate: 72 bytes. Both directions are
 * those in which light travels. Normals and directions have unit length; normals point outside. */
typedef struct TynBssrdfPath {
  float entry_position[3];  /* x_i, scene units */
  float entry_normal[3];    /* n_i */
  float entry_direction[3]; /* w_i, towards the surface from outside: against the normal */
  float exit_position[3];   /* x_o, scene units */
  float exit_normal[3];     /* n_o */
  float exit_direction[3];  /* w_o, away from the surface: on the normal's side */
} TynBssrdfPath;

/* What the fit of normalized diffusion was made for (Christensen & Burley 2015). */
enum {
  TYN_NORMALIZED_SEARCHLIGHT = 0, /* light that arrives perpendicularly; radii in mean free paths */
  TYN_NORMALIZED_DIFFUSE = 1,     /* diffuse light; radii in mean free paths */
  TYN_NORMALIZED_DMFP = 2,        /* perpendicular light; radii in diffuse mean free paths */
  TYN_NORMALIZED_FIT_COUNT = 3
};

/* How light arrives. */
enum {
  TYN_INCIDENCE_COLLIMATED = 0, /* all along one direction, `angle` from the normal */
  TYN_INCIDENCE_DIFFUSE = 1     /* radiance equal from everywhere above (cosine-distributed flux) */
};

/* Where light arrives: around the origin. Matters to what is resolved over the radius only. */
enum {
  TYN_BEAM_PENCIL = 0,  /* at the origin */
  TYN_BEAM_DISC = 1,    /* uniform on a disc of radius beam_radius */
  TYN_BEAM_GAUSSIAN = 2 /* density proportional to exp(-2 r^2 / beam_radius^2): beam_radius is the 1/e^2 radius */
};

#endif
