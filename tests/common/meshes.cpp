// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
#include "common/meshes.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>

namespace tyn_test {
namespace {

constexpr double PI = 3.14159265358979323846;

struct Point {
  double x, y, z;
};

Point point(const MeshData &mesh, uint32_t vertex) {
  const float *p = &mesh.positions[3 * size_t(vertex)];
  return {p[0], p[1], p[2]};
}

Point cross(Point a, Point b) { return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x}; }

// Twice the triangle's area, along its normal.
Point area_vector(const MeshData &mesh, size_t triangle) {
  Point a = point(mesh, mesh.indices[3 * triangle]), b = point(mesh, mesh.indices[3 * triangle + 1]),
        c = point(mesh, mesh.indices[3 * triangle + 2]);
  return cross({b.x - a.x, b.y - a.y, b.z - a.z}, {c.x - a.x, c.y - a.y, c.z - a.z});
}

void add_normal(MeshData &mesh, double x, double y, double z) {
  double length = std::sqrt(x * x + y * y + z * z);
  for (double value : {x, y, z})
    mesh.normals.push_back(float(value / length));
}

void push_to_sphere(MeshData &mesh) {
  for (size_t i = 0; i < mesh.positions.size(); i += 3) {
    float *p = &mesh.positions[i];
    double length = std::sqrt(double(p[0]) * p[0] + double(p[1]) * p[1] + double(p[2]) * p[2]);
    for (int k = 0; k < 3; k++)
      p[k] = float(p[k] / length);
  }
}

MeshData icosahedron() {
  const double t = (1 + std::sqrt(5.0)) / 2;
  MeshData mesh;
  for (int i = 0; i < 3; i++)
    for (double sign : {-1.0, 1.0})
      for (double other : {-t, t}) {
        double p[3];
        p[i] = sign, p[(i + 1) % 3] = other, p[(i + 2) % 3] = 0;
        mesh.add_vertex(p[0], p[1], p[2]);
      }
  // Faces are the triples of vertices that are one edge length (2) apart; wound by their own normal.
  for (uint32_t a = 0; a < 12; a++)
    for (uint32_t b = a + 1; b < 12; b++)
      for (uint32_t c = b + 1; c < 12; c++) {
        auto distance = [&](uint32_t i, uint32_t j) {
          Point p = point(mesh, i), q = point(mesh, j);
          return std::hypot(p.x - q.x, p.y - q.y, p.z - q.z);
        };
        if (distance(a, b) > 2.01 || distance(b, c) > 2.01 || distance(a, c) > 2.01)
          continue;
        mesh.add_triangle(a, b, c);
        Point n = area_vector(mesh, mesh.triangle_count() - 1), p = point(mesh, a);
        if (n.x * p.x + n.y * p.y + n.z * p.z < 0)
          std::swap(mesh.indices[mesh.indices.size() - 1], mesh.indices[mesh.indices.size() - 2]);
      }
  return mesh;
}

uint32_t midpoint(MeshData &mesh, std::map<std::pair<uint32_t, uint32_t>, uint32_t> &known, uint32_t a, uint32_t b) {
  auto key = std::make_pair(std::min(a, b), std::max(a, b));
  auto found = known.find(key);
  if (found != known.end())
    return found->second;
  Point p = point(mesh, a), q = point(mesh, b);
  return known[key] = mesh.add_vertex((p.x + q.x) / 2, (p.y + q.y) / 2, (p.z + q.z) / 2);
}

// A point of a subdivided face: up to three corners, in order, and how many steps it is from the other sides. Faces that meet
// on an edge say the same about the points on it.
using Steps = std::array<std::pair<uint32_t, uint32_t>, 3>;

uint32_t geodesic_vertex(MeshData &mesh, std::map<Steps, uint32_t> &known, const MeshData &corners, Steps steps) {
  for (auto &[corner, count] : steps)
    corner = count ? corner : 0;
  std::sort(steps.begin(), steps.end());
  auto found = known.find(steps);
  if (found != known.end())
    return found->second;
  Point sum{};
  for (auto [corner, count] : steps) {
    Point p = point(corners, corner);
    sum.x += count * p.x, sum.y += count * p.y, sum.z += count * p.z;
  }
  double length = std::hypot(sum.x, sum.y, sum.z);
  return known[steps] = mesh.add_vertex(sum.x / length, sum.y / length, sum.z / length);
}

// A grid of (columns + 1) x (rows + 1) points, function(u, v) with u, v in [0, 1]; wound so that du x dv is the normal.
template <class Function>
MeshData grid(uint32_t columns, uint32_t rows, Function function) {
  MeshData mesh;
  for (uint32_t j = 0; j <= rows; j++)
    for (uint32_t i = 0; i <= columns; i++) {
      Point p = function(double(i) / columns, double(j) / rows);
      mesh.add_vertex(p.x, p.y, p.z);
    }
  for (uint32_t j = 0; j < rows; j++)
    for (uint32_t i = 0; i < columns; i++) {
      uint32_t a = j * (columns + 1) + i, b = a + 1, c = a + columns + 1, d = c + 1;
      mesh.add_triangle(a, b, d);
      mesh.add_triangle(a, d, c);
    }
  return mesh;
}

} // namespace

uint32_t MeshData::add_vertex(double x, double y, double z) {
  positions.insert(positions.end(), {float(x), float(y), float(z)});
  return vertex_count() - 1;
}

void MeshData::add_triangle(uint32_t a, uint32_t b, uint32_t c) { indices.insert(indices.end(), {a, b, c}); }

void MeshData::append(const MeshData &other) {
  uint32_t first = vertex_count();
  positions.insert(positions.end(), other.positions.begin(), other.positions.end());
  normals.insert(normals.end(), other.normals.begin(), other.normals.end());
  uvs.insert(uvs.end(), other.uvs.begin(), other.uvs.end());
  for (uint32_t index : other.indices)
    indices.push_back(first + index);
  // Attributes only make sense if both parts have them.
  if (normals.size() != positions.size())
    normals.clear();
  if (uvs.size() != 2 * size_t(vertex_count()))
    uvs.clear();
}

TynMesh MeshData::view() const {
  TynMesh mesh = tyn_mesh();
  mesh.positions = positions.data();
  mesh.vertex_count = vertex_count();
  mesh.normals = normals.empty() ? nullptr : normals.data();
  mesh.uvs = uvs.empty() ? nullptr : uvs.data();
  mesh.indices = indices.data();
  mesh.triangle_count = triangle_count();
  return mesh;
}

double MeshData::area() const {
  double sum = 0;
  for (size_t i = 0; i < triangle_count(); i++) {
    Point n = area_vector(*this, i);
    sum += std::hypot(n.x, n.y, n.z) / 2;
  }
  return sum;
}

double MeshData::volume() const {
  double sum = 0;
  for (size_t i = 0; i < triangle_count(); i++) {
    Point n = area_vector(*this, i), p = point(*this, indices[3 * i]);
    sum += (n.x * p.x + n.y * p.y + n.z * p.z) / 6;
  }
  return sum;
}

MeshData tetrahedron() {
  MeshData mesh;
  mesh.positions = {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1};
  mesh.indices = {0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3};
  return mesh;
}

MeshData cube() { return box(2, 2, 2); }

MeshData box(float width, float height, float depth) {
  MeshData mesh;
  for (int i = 0; i < 8; i++)
    mesh.add_vertex((i & 1 ? 0.5 : -0.5) * width, (i & 2 ? 0.5 : -0.5) * height, (i & 4 ? 0.5 : -0.5) * depth);
  mesh.indices = {0, 4, 6, 0, 6, 2, 1, 3, 7, 1, 7, 5,  // -x +x
                  0, 1, 5, 0, 5, 4, 2, 6, 7, 2, 7, 3,  // -y +y
                  0, 2, 3, 0, 3, 1, 4, 5, 7, 4, 7, 6}; // -z +z
  return mesh;
}

MeshData thin_slab(float width, float thickness, uint32_t cells) {
  const double w = width, t = thickness;
  MeshData mesh = grid(cells, cells, [=](double u, double v) { return Point{(u - 0.5) * w, t / 2, (0.5 - v) * w}; });
  mesh.append(grid(cells, cells, [=](double u, double v) { return Point{(u - 0.5) * w, -t / 2, (v - 0.5) * w}; }));
  // The rim: each border edge of the top joined to the bottom's. Seams repeat positions.
  const double corners[5][2] = {{-0.5, 0.5}, {0.5, 0.5}, {0.5, -0.5}, {-0.5, -0.5}, {-0.5, 0.5}};
  for (int side = 0; side < 4; side++) {
    const double *a = corners[side], *b = corners[side + 1];
    mesh.append(grid(cells, 1, [=](double u, double v) {
      return Point{(a[0] + u * (b[0] - a[0])) * w, (v - 0.5) * t, (a[1] + u * (b[1] - a[1])) * w};
    }));
  }
  return mesh;
}

MeshData subdivided(MeshData mesh) {
  std::map<std::pair<uint32_t, uint32_t>, uint32_t> known;
  std::vector<uint32_t> old;
  old.swap(mesh.indices);
  for (size_t i = 0; i < old.size(); i += 3) {
    uint32_t a = old[i], b = old[i + 1], c = old[i + 2];
    uint32_t ab = midpoint(mesh, known, a, b), bc = midpoint(mesh, known, b, c), ca = midpoint(mesh, known, c, a);
    mesh.add_triangle(a, ab, ca);
    mesh.add_triangle(ab, b, bc);
    mesh.add_triangle(ca, bc, c);
    mesh.add_triangle(ab, bc, ca);
  }
  return mesh;
}

MeshData icosphere(uint32_t level, float radius) {
  MeshData mesh = icosahedron();
  push_to_sphere(mesh);
  for (uint32_t i = 0; i < level; i++) {
    mesh = subdivided(mesh);
    push_to_sphere(mesh);
  }
  mesh.normals = mesh.positions;
  return scaled(mesh, radius);
}

MeshData geodesic_sphere(uint32_t frequency) {
  const MeshData corners = icosahedron();
  MeshData mesh;
  std::map<Steps, uint32_t> known;
  for (size_t face = 0; face < corners.triangle_count(); face++) {
    const uint32_t *c = &corners.indices[3 * face];
    auto vertex = [&](uint32_t i, uint32_t j) {
      return geodesic_vertex(mesh, known, corners, {{{c[0], frequency - i - j}, {c[1], i}, {c[2], j}}});
    };
    for (uint32_t i = 0; i < frequency; i++)
      for (uint32_t j = 0; i + j < frequency; j++) {
        mesh.add_triangle(vertex(i, j), vertex(i + 1, j), vertex(i, j + 1));
        if (i + j + 1 < frequency)
          mesh.add_triangle(vertex(i + 1, j), vertex(i + 1, j + 1), vertex(i, j + 1));
      }
  }
  return mesh;
}

MeshData torus(float major, float minor, uint32_t around, uint32_t across) {
  MeshData mesh;
  for (uint32_t i = 0; i < around; i++)
    for (uint32_t j = 0; j < across; j++) {
      double a = 2 * PI * i / around, b = 2 * PI * j / across;
      double r = double(major) + double(minor) * std::cos(b);
      mesh.add_vertex(r * std::cos(a), minor * std::sin(b), -r * std::sin(a));
      add_normal(mesh, std::cos(b) * std::cos(a), std::sin(b), -std::cos(b) * std::sin(a));
    }
  for (uint32_t i = 0; i < around; i++)
    for (uint32_t j = 0; j < across; j++) {
      uint32_t a = i * across + j, b = (i + 1) % around * across + j;
      uint32_t c = i * across + (j + 1) % across, d = (i + 1) % around * across + (j + 1) % across;
      mesh.add_triangle(a, b, d);
      mesh.add_triangle(a, d, c);
    }
  return mesh;
}

MeshData bumpy_sphere(uint32_t level, float amplitude) { return bumpy(without_normals(icosphere(level)), amplitude); }

MeshData hollow_sphere(uint32_t level, float outer, float inner) {
  MeshData mesh = icosphere(level, outer);
  mesh.append(inverted(icosphere(level, inner)));
  return mesh;
}

MeshData needles(uint32_t count, float length) {
  MeshData mesh;
  uint32_t top = mesh.add_vertex(0, length, 0), bottom = mesh.add_vertex(0, -double(length), 0);
  for (uint32_t i = 0; i < count; i++)
    mesh.add_vertex(std::cos(2 * PI * i / count), 0, -std::sin(2 * PI * i / count));
  for (uint32_t i = 0; i < count; i++) {
    uint32_t a = 2 + i, b = 2 + (i + 1) % count;
    mesh.add_triangle(top, a, b);
    mesh.add_triangle(bottom, b, a);
  }
  return mesh;
}

MeshData cube_with_sliver() {
  MeshData mesh = cube();
  // The front face (+z) was {4, 5, 7}, {4, 7, 6}. Its lower edge 4-5 gets a vertex that is not quite in the middle.
  uint32_t m = mesh.add_vertex(0.3, -1, 1);
  mesh.indices.resize(30);
  for (uint32_t corner : {4u, m, 6u, m, 7u, 6u, m, 5u, 7u, 4u, 5u, m})
    mesh.indices.push_back(corner);
  return mesh;
}

MeshData single_triangle() {
  MeshData mesh;
  mesh.positions = {0, 0, 0, 1, 0, 0, 0, 1, 0};
  mesh.indices = {0, 1, 2};
  return mesh;
}

MeshData quad(float size) {
  const float h = size / 2;
  MeshData mesh;
  mesh.positions = {-h, 0, h, h, 0, h, h, 0, -h, -h, 0, -h};
  mesh.uvs = {0, 1, 1, 1, 1, 0, 0, 0};
  mesh.indices = {0, 1, 2, 0, 2, 3};
  return mesh;
}

MeshData open_hemisphere(uint32_t level) {
  MeshData mesh = icosphere(level);
  std::vector<uint32_t> kept;
  for (size_t i = 0; i < mesh.indices.size(); i += 3) {
    double y = 0;
    for (size_t k = 0; k < 3; k++)
      y += mesh.positions[3 * size_t(mesh.indices[i + k]) + 1];
    if (y > 0)
      kept.insert(kept.end(), mesh.indices.begin() + long(i), mesh.indices.begin() + long(i) + 3);
  }
  mesh.indices = kept;
  return mesh;
}

MeshData mobius_strip(uint32_t around) {
  MeshData mesh;
  for (uint32_t i = 0; i < around; i++)
    for (double s : {-0.3, 0.3}) {
      double a = 2 * PI * i / around, r = 1 + s * std::cos(a / 2);
      mesh.add_vertex(r * std::cos(a), s * std::sin(a / 2), r * std::sin(a));
    }
  for (uint32_t i = 0; i < around; i++) {
    bool last = i + 1 == around; // where the two borders change places
    uint32_t a = 2 * i, b = a + 1, c = last ? 1 : a + 2, d = last ? 0 : a + 3;
    mesh.add_triangle(a, b, d);
    mesh.add_triangle(a, d, c);
  }
  return mesh;
}

MeshData three_fins() {
  MeshData mesh;
  mesh.positions = {0, 0, 0, 0, 1, 0, 1, 0, 0, -1, 0, 1, -1, 0, -1};
  mesh.indices = {0, 1, 2, 0, 1, 3, 0, 1, 4};
  return mesh;
}

MeshData with_zero_area_triangles(MeshData mesh) {
  uint32_t a = mesh.indices[0], b = mesh.indices[1];
  mesh.add_triangle(a, b, b);
  uint32_t copy = mesh.vertex_count();
  std::vector<float> p(mesh.positions.begin() + 3 * long(a), mesh.positions.begin() + 3 * long(a) + 3);
  mesh.positions.insert(mesh.positions.end(), p.begin(), p.end());
  if (!mesh.normals.empty()) {
    std::vector<float> n(mesh.normals.begin() + 3 * long(a), mesh.normals.begin() + 3 * long(a) + 3);
    mesh.normals.insert(mesh.normals.end(), n.begin(), n.end());
  }
  mesh.uvs.clear();
  mesh.add_triangle(a, copy, b);
  return mesh;
}

MeshData translated(MeshData mesh, float x, float y, float z) {
  for (size_t i = 0; i < mesh.positions.size(); i += 3) {
    mesh.positions[i] += x;
    mesh.positions[i + 1] += y;
    mesh.positions[i + 2] += z;
  }
  return mesh;
}

MeshData scaled(MeshData mesh, float factor) {
  for (float &value : mesh.positions)
    value *= factor;
  return mesh;
}

MeshData inverted(MeshData mesh) {
  for (float &value : mesh.normals)
    value = -value;
  return with_flipped(std::move(mesh), 1);
}

MeshData with_flipped(MeshData mesh, uint32_t period) {
  for (size_t i = 0; i < mesh.triangle_count(); i += period)
    std::swap(mesh.indices[3 * i + 1], mesh.indices[3 * i + 2]);
  return mesh;
}

MeshData unwelded(const MeshData &mesh) {
  MeshData result;
  for (uint32_t index : mesh.indices) {
    const size_t i = index;
    result.positions.insert(result.positions.end(), &mesh.positions[3 * i], &mesh.positions[3 * i] + 3);
    if (!mesh.normals.empty())
      result.normals.insert(result.normals.end(), &mesh.normals[3 * i], &mesh.normals[3 * i] + 3);
    if (!mesh.uvs.empty())
      result.uvs.insert(result.uvs.end(), &mesh.uvs[2 * i], &mesh.uvs[2 * i] + 2);
    result.indices.push_back(uint32_t(result.indices.size()));
  }
  return result;
}

MeshData without_normals(MeshData mesh) {
  mesh.normals.clear();
  return mesh;
}

MeshData bumpy(MeshData sphere, float amplitude) {
  for (size_t i = 0; i < sphere.positions.size(); i += 3) {
    float *p = &sphere.positions[i];
    double radius = 1 + amplitude * std::sin(7.0 * p[0] + 1) * std::sin(5.0 * p[1]) * std::cos(6.0 * p[2]);
    for (int k = 0; k < 3; k++)
      p[k] = float(p[k] * radius);
  }
  return sphere;
}

std::vector<NamedMesh> closed_meshes() {
  return {{"tetrahedron", tetrahedron()},
          {"cube", cube()},
          {"thin slab", thin_slab(2, 0.01f, 16)},
          {"icosphere", icosphere(4)},
          {"torus", torus(1, 0.4f, 48, 24)},
          {"bumpy sphere", bumpy_sphere(4, 0.3f)},
          {"hollow sphere", hollow_sphere(3, 1, 0.6f)},
          {"needles", needles(256, 40)},
          {"unwelded torus", unwelded(torus(1, 0.3f, 32, 16))},
          {"far away sphere", translated(icosphere(3), 1000, -2000, 500)}};
}

std::vector<NamedMesh> hostile_meshes() {
  auto both = [](MeshData mesh, const MeshData &other) {
    mesh.append(other);
    return mesh;
  };
  MeshData repeated = cube();
  repeated.add_triangle(repeated.indices[1], repeated.indices[2], repeated.indices[0]);
  return {{"sliver", cube_with_sliver()},
          {"zero areas", with_zero_area_triangles(icosphere(2))},
          {"one triangle twice", repeated},
          {"every triangle twice", both(cube(), cube())},
          {"cubes that share an edge", both(cube(), translated(cube(), 2, 2, 0))},
          {"cubes that share a face", both(cube(), translated(cube(), 2, 0, 0))},
          {"cubes that share a vertex", both(cube(), translated(cube(), 2, 2, 2))},
          {"cubes side by side", both(cube(), translated(cube(), 2, 0.5f, 0.3f))},
          {"overlapping cubes", both(cube(), translated(cube(), 1.1f, 0.9f, 0.7f))},
          {"a cross", both(box(4, 1, 1), box(1, 4, 0.9f))},
          {"a sphere in a sphere", both(icosphere(3), icosphere(3, 0.5f))},
          {"a needle", needles(4, 1e6f)}};
}

std::vector<NamedMesh> walked_meshes() {
  std::vector<NamedMesh> meshes = closed_meshes();
  meshes.push_back({"hemisphere with a hole", open_hemisphere(3)});
  for (const NamedMesh &hostile : hostile_meshes())
    meshes.push_back(hostile);
  return meshes;
}

std::vector<NamedMesh> watertight_meshes() {
  std::vector<NamedMesh> meshes = closed_meshes();
  meshes.push_back({"cube with sliver", cube_with_sliver()});
  return meshes;
}

std::string test_name(const NamedMesh &named) {
  std::string name = named.name;
  std::replace(name.begin(), name.end(), ' ', '_');
  return name;
}

} // namespace tyn_test
