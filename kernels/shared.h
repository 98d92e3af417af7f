// SPDX-License-Identifier: Apache-2.0
// The records that host and kernels share beyond the public ones: one definition, 4-byte scalars only.
// tests/unit compares the sizes and offsets that the host sees with those that a kernel reports.
#ifndef TYN_SHARED_H
#define TYN_SHARED_H

#include "tyndall/tyndall_types.h"

// ---- Acceleration structure -----------------------------------------------------------------------------------------
// One tree of 8-wide nodes for the whole scene. Every mesh has its own root inside it (TynMeshRecord::root), so that a walk
// can be confined to one mesh; the scene's root is node 0, whose subtrees end in the roots of the meshes.
#define TYN_BVH_WIDTH 8
#define TYN_BLOCK_SIZE 4
#define TYN_BVH_STACK 256 // entries; the build refuses deeper trees (7 per level + 1)

// A child: an inner node's index, or TYN_CHILD_LEAF | first block << 4 | number of blocks (1 .. 15), or TYN_CHILD_EMPTY.
#define TYN_CHILD_LEAF 0x80000000u
#define TYN_CHILD_EMPTY 0xffffffffu

typedef struct TynBvhNode {
  float bounds[6][TYN_BVH_WIDTH]; // lower x, y, z, upper x, y, z; an empty child has lower = +inf, upper = -inf
  uint32_t child[TYN_BVH_WIDTH];
} TynBvhNode; // 224 bytes

// Four triangles. Unused places repeat triangle TYN_NONE with all-zero positions, which nothing hits.
typedef struct TynTriangleBlock {
  float position[9][TYN_BLOCK_SIZE]; // p0 x, y, z, p1 x, y, z, p2 x, y, z
  uint32_t triangle[TYN_BLOCK_SIZE]; // scene-wide index
} TynTriangleBlock;                  // 160 bytes

// ---- Geometry ---------------------------------------------------------------------------------------------------------
// Vertices and triangles of all meshes, one after the other.
typedef struct TynTriangleRecord {
  uint32_t vertex[3]; // scene-wide; in outward winding if the mesh holds a medium, else the caller's
  uint32_t mesh;
  uint32_t material; // TYN_NONE never: the host resolves the default
  float
      horizon; // a flight that starts on the triangle and whose direction's inward component along the normal is at least
               // this is clear of the surface for the mesh's horizon_reach; above 1: none is
} TynTriangleRecord; // 24 bytes

#define TYN_MESH_HAS_NORMALS 1u
#define TYN_MESH_HAS_UVS 2u
#define TYN_MESH_CLOSED 4u

typedef struct TynMeshRecord {
  uint32_t root;           // TynBvhNode index of the mesh's own root
  uint32_t first_triangle; // scene-wide
  uint32_t triangle_count;
  uint32_t medium; // TYN_NONE: opaque
  uint32_t flags;  // TYN_MESH_*
  float slack;     // see traverse.clh: how far behind a ray's origin a leaving hit still counts, 2^-20 of the largest
                   // absolute coordinate of the mesh, as a power of two
  float lower[3];
  float upper[3]; // bounds, widened by slack
  // The grid of distance_bound.clh; cells are stored x fastest.
  uint32_t grid_first;   // index of its first cell
  uint32_t grid_size[3]; // cells along x, y, z, from `lower` on; 1 for a mesh without a grid
  float grid_cell;       // edge of a cell; 0 for a mesh without a grid, like the others below
  float grid_per_cell;   // 1 / grid_cell
  float grid_step;       // a code's square times this is the distance
  // The grid of local roots: see lib/scene/local_roots.hpp; x fastest, from `lower` on.
  uint32_t local_first; // index of its first cell, which holds a TynBvhNode number, or TYN_NONE where nothing is near
  uint32_t local_size[3];
  float local_cell; // edge of a cell; without local roots one large cell has the mesh's own, or this is 0
  float local_per_cell;
  float horizon_reach; // see TynTriangleRecord::horizon
} TynMeshRecord;       // 104 bytes

#define TYN_LOCAL_REACH 0.5f // cells around a cell of the local roots' grid that its root is for, too
#define TYN_NO_HORIZON 2.0f  // TynTriangleRecord::horizon that no direction reaches

// A cell of a mesh's grid in 32 bits, from the lowest on:
//   8 code: the square of it times grid_step is a lower bound of the distance from the cell's centre to the surface
//   8 offset: no point q of the surface in a ball around the centre c has n (q - c) < offset * STEP - 1, lengths in cells
//   7, 7 n: octahedral, -63 .. 63; its components' absolute values sum to 1
//   2 reach: (reach + 1) * STEP is the radius of the ball, in cells
#define TYN_CLEAR_PLANE_STEP (1.0f / 64.0f)
#define TYN_CLEAR_REACHES 4
#define TYN_CLEAR_REACH_STEP 1.0f

// ---- Media ------------------------------------------------------------------------------------------------------------
// A phase function (tyndall_phase.h). Isotropic ones are Henyey-Greenstein with g = 0 here.
typedef struct TynPhaseRecord {
  uint32_t kind; // TYN_PHASE_*, never ISOTROPIC
  float g, g2;
  float weight;
  float alpha;
  uint32_t table; // TABULATED: offset in the array of tables, in floats; see phase_tabulated.clh
  uint32_t count; // of entries of the table
  uint32_t reserved;
} TynPhaseRecord; // 32 bytes

typedef struct TynMediumRecord {
  float sigma_t[3];
  float g; // mean cosine, whatever the phase function
  float albedo[3];
  float ior;
  uint32_t phase; // index of a TynPhaseRecord, or TYN_NONE: Henyey-Greenstein with g
  uint32_t reserved[3];
} TynMediumRecord; // 48 bytes

// ---- Walks ------------------------------------------------------------------------------------------------------------
typedef struct TynWalkParameters {
  uint32_t seed[2];         // low, high word
  uint32_t first_path[2];   // low, high word of the path number of the first entry
  uint32_t count;           // number of entries
  uint32_t max_scatterings; // 0: no cap
  float roulette_threshold; // 0: no roulette
  uint32_t mesh_count;
  uint32_t medium_count;
  uint32_t slice;           // entries that a work-item takes at a time
  uint32_t callers_winding; // 1: exits give u and v for the caller's order of vertices, else for the scene's
} TynWalkParameters;        // 44 bytes

// What one walk adds to the ledger beside what its exit says.
typedef struct TynWalkTally {
  float reflected[3];
  float absorbed[3];
  float balance[3];
  uint32_t rays; // traced: fewer than flights, see walk_flight.clh
} TynWalkTally;  // 40 bytes

#endif
