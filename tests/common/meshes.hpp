// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
// Meshes for tests, made from formulas. Closed ones are wound outwards (counter-clockwise seen from outside) unless
// their name says otherwise.
#pragma once

#include <cstdint>
#include <ostream>
#include <string>
#include <vector>

#include "tyndall/tyndall.h"

namespace tyn_test {

struct MeshData {
  std::vector<float> positions;  // x y z
  std::vector<float> normals;    // x y z, or empty
  std::vector<float> uvs;        // u v, or empty
  std::vector<uint32_t> indices; // 3 a triangle

  uint32_t vertex_count() const { return uint32_t(positions.size() / 3); }
  uint32_t triangle_count() const { return uint32_t(indices.size() / 3); }
  uint32_t add_vertex(double x, double y, double z); // returns its index
  void add_triangle(uint32_t a, uint32_t b, uint32_t c);
  void append(const MeshData &other);

  // The public description, which points into this object. Medium and material are TYN_NONE.
  TynMesh view() const;
  // Area, and volume by the divergence theorem, summed in double.
  double area() const;
  double volume() const;
};

// ---- closed ----
MeshData tetrahedron();                               // the corner of the unit cube: volume 1/6
MeshData cube();                                      // [-1, 1]^3, 8 vertices, 12 triangles
MeshData box(float width, float height, float depth); // centred on the origin
MeshData thin_slab(float width, float thickness,
                   uint32_t cells); // y is the thin axis; cells x cells on both faces
MeshData icosphere(uint32_t level,
                   float radius = 1.0f);      // 20 x 4^level triangles, with unit normals
MeshData geodesic_sphere(uint32_t frequency); // 20 x frequency^2 triangles, radius 1, without normals
MeshData torus(float major, float minor, uint32_t around,
               uint32_t across);                        // about the y axis, with normals
MeshData bumpy_sphere(uint32_t level, float amplitude); // star-shaped, not convex
// A solid between two spheres: the inner one is wound inwards. Two components.
MeshData hollow_sphere(uint32_t level, float outer, float inner);
MeshData needles(uint32_t count,
                 float length); // a double pyramid of very thin triangles, aspect ratio about length x count
// A cube one of whose edges has an extra vertex on it that only the front face uses: the zero-area sliver between
// them is there, with three distinct vertices, so that the surface is closed.
MeshData cube_with_sliver();

// ---- open or broken ----
MeshData single_triangle();
MeshData quad(float size); // two triangles in the plane y = 0, facing +y, with uvs
MeshData open_hemisphere(uint32_t level);
MeshData mobius_strip(uint32_t around);           // no consistent orientation exists
MeshData three_fins();                            // three triangles on one edge
MeshData with_zero_area_triangles(MeshData mesh); // appends one with a repeated vertex and one with repeated positions

// ---- variations ----
MeshData translated(MeshData mesh, float x, float y, float z);
MeshData scaled(MeshData mesh, float factor);
MeshData inverted(MeshData mesh);                      // every triangle turned; normals point inwards
MeshData with_flipped(MeshData mesh, uint32_t period); // triangles 0, period, 2 period, ... turned
MeshData unwelded(const MeshData &mesh);               // three vertices of its own for every triangle
MeshData without_normals(MeshData mesh);
MeshData subdivided(MeshData mesh);               // 4 triangles for each: 4 i .. 4 i + 3 for triangle i; positions only
MeshData bumpy(MeshData sphere, float amplitude); // bumps on a sphere of radius 1 about the origin

// Meshes that are closed, by name, for tests over all of them.
struct NamedMesh {
  std::string name;
  MeshData mesh;
};
inline void PrintTo(const NamedMesh &named, std::ostream *out) { *out << named.name; }
std::vector<NamedMesh> closed_meshes();
// What files do hold: slivers, triangles given twice, shells that touch or overlap, a needle.
std::vector<NamedMesh> hostile_meshes();
// All of the above, and one with a hole.
std::vector<NamedMesh> walked_meshes();
// Closed ones, and a cube with a triangle without area in an edge.
std::vector<NamedMesh> watertight_meshes();
// What GoogleTest takes for the name of a test over one.
std::string test_name(const NamedMesh &named);

} // namespace tyn_test
