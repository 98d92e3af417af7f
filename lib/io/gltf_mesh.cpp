// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
#include "io/gltf_mesh.hpp"

#include <algorithm>
#include <cinttypes>

namespace tyn::io {
namespace {

// So many elements an accessor may always have, however few triangles are asked for.
constexpr uint64_t MOST_SMALL_ELEMENTS = 1 << 20;
// The largest |coordinate| that tyn_scene_add_mesh takes.
constexpr float LARGEST_COORDINATE = 1e10f;

Vector vector_at(const std::vector<float> &values, size_t index) {
  return {values[3 * index], values[3 * index + 1], values[3 * index + 2]};
}

bool has_any_texture(const TynMaterial &material) {
  for (const TynTexture *texture :
       {&material.base_color_texture, &material.metallic_roughness_texture, &material.normal_texture,
        &material.emission_texture, &material.transmission_texture, &material.multiscatter_color_texture,
        &material.scatter_strength_texture})
    if (texture->image != TYN_NONE)
      return true;
  return false;
}

void append_positions(const Triangles &triangles, const Affine &world, std::vector<float> &to,
                      const std::string &where) {
  for (size_t i = 0; i < triangles.vertex_count(); i++) {
    const Vector p = world.point(vector_at(triangles.positions, i));
    for (const double component : p) {
      to.push_back(float(component));
      if (!(std::abs(to.back()) <= LARGEST_COORDINATE)) // a NaN fails
        fail(TYN_ERROR_FORMAT, "%s: vertex %zu lies at %g %g %g in world space, too far out: coordinates reach to %g",
             where.c_str(), i, p[0], p[1], p[2], double(LARGEST_COORDINATE));
    }
  }
}

// Unit normals in world space; (0, 0, 0) stands for one that is not usable.
void append_normals(const Triangles &triangles, const Affine &world, std::vector<float> &to) {
  for (size_t i = 0; 3 * i < triangles.normals.size(); i++) {
    const Vector n = world.normal(vector_at(triangles.normals, i));
    const double size = length(n);
    const bool usable = size > 0 && std::isfinite(size);
    for (const double component : n)
      to.push_back(usable ? float(component / size) : 0.0f);
  }
}

// Normals that are zero or not finite are replaced by the mean of the geometric normals around the vertex.
size_t repair_normals(LoadedMesh &mesh) {
  std::vector<Vector> sums(mesh.normals.size() / 3, Vector{0, 0, 0});
  const auto broken = [&](size_t v) {
    return mesh.normals[3 * v] == 0 && mesh.normals[3 * v + 1] == 0 && mesh.normals[3 * v + 2] == 0;
  };
  for (size_t t = 0; t + 2 < mesh.indices.size(); t += 3) {
    const Vector a = vector_at(mesh.positions, mesh.indices[t]);
    const Vector n =
        cross(vector_at(mesh.positions, mesh.indices[t + 1]) - a, vector_at(mesh.positions, mesh.indices[t + 2]) - a);
    for (size_t k = 0; k < 3; k++)
      sums[mesh.indices[t + k]] = sums[mesh.indices[t + k]] + n;
  }
  size_t repaired = 0;
  for (size_t v = 0; v < sums.size(); v++) {
    if (!broken(v))
      continue;
    const double size = length(sums[v]);
    for (size_t c = 0; c < 3; c++)
      mesh.normals[3 * v + c] = size > 0 ? float(sums[v][c] / size) : float(c == 2);
    repaired++;
  }
  return repaired;
}

} // namespace

GltfMeshes::GltfMeshes(GltfDocument &source, const TynGltfOptions &options, Warnings &sink, LoadedScene &result)
    : document(source), warnings(sink), scene(result),
      accessors(source, std::max(MOST_SMALL_ELEMENTS, std::min<uint64_t>(options.max_triangles, TYN_NONE / 3) * 3)),
      materials(source, options, sink, result), max_triangles(options.max_triangles) {}

// A primitive with what its material says.
struct GltfMeshes::Piece {
  Triangles triangles;
  MaterialUse use;
  std::string where; // its JSON path
};

std::vector<GltfMeshes::Piece> GltfMeshes::read_pieces(int mesh) {
  std::vector<Piece> pieces;
  const std::vector<tinygltf::Primitive> &primitives = document.model.meshes[size_t(mesh)].primitives;
  for (size_t i = 0; i < primitives.size(); i++) {
    Piece piece;
    piece.where = text("meshes[%d].primitives[%zu]", mesh, i);
    piece.use = materials.get(primitives[i].material);
    piece.triangles = read_primitive(document, accessors, primitives[i], piece.use.uv_set, piece.where, warnings);
    if (piece.triangles.indices.empty())
      continue;
    count(piece.triangles, piece.where);
    warn_about_uvs(piece.triangles, piece.use, piece.where);
    pieces.push_back(std::move(piece));
  }
  return pieces;
}

void GltfMeshes::add(const PlacedNode &node) {
  const tinygltf::Node &source = document.model.nodes[size_t(node.index)];
  if (source.skin >= 0)
    warnings.add("nodes[%d] is skinned, which is not supported: the mesh keeps its rest pose", node.index);
  if (node.world.determinant() == 0)
    warnings.add("nodes[%d] flattens its mesh: its transform has a scale of 0", node.index);
  std::vector<Piece> pieces = read_pieces(source.mesh);
  std::vector<LoadedMesh> parts; // one for each medium
  for (Piece &piece : pieces) {
    const auto same_medium = [&](const LoadedMesh &part) { return part.medium == piece.use.medium; };
    // Without normals anywhere a mesh has none, and is shaded with its geometric ones.
    const bool some_have_normals = std::any_of(pieces.begin(), pieces.end(), [&](const Piece &other) {
      return other.use.medium == piece.use.medium && !other.triangles.normals.empty();
    });
    if (some_have_normals && piece.triangles.normals.empty())
      add_flat_normals(piece.triangles);
    auto part = std::find_if(parts.begin(), parts.end(), same_medium);
    if (part == parts.end())
      part = parts.emplace(parts.end());
    part->medium = piece.use.medium;
    append(piece, node.world, *part);
  }
  for (LoadedMesh &part : parts) {
    part.name = source.name.empty() ? document.model.meshes[size_t(source.mesh)].name : source.name;
    if (const size_t repaired = part.normals.empty() ? 0 : repair_normals(part))
      warnings.add("meshes[%d]: %zu normals are zero or not finite and were replaced", source.mesh, repaired);
    scene.meshes.push_back(std::move(part));
  }
}

void GltfMeshes::count(const Triangles &triangles, const std::string &where) {
  triangle_count += triangles.triangle_count();
  if (triangle_count > max_triangles)
    fail(TYN_ERROR_FORMAT, "%s: the scene has more than %" PRIu64 " triangles, the most that are read", where.c_str(),
         max_triangles);
}

void GltfMeshes::warn_about_uvs(const Triangles &triangles, const MaterialUse &use, const std::string &where) {
  if (triangles.uvs.empty() && has_any_texture(scene.materials[use.material].value))
    warnings.add("%s has textures, but no TEXCOORD_%d: their texel at 0 0 is used everywhere", where.c_str(),
                 use.uv_set);
}

void GltfMeshes::append(const Piece &piece, const Affine &world, LoadedMesh &mesh) {
  const Triangles &triangles = piece.triangles;
  const size_t before = mesh.positions.size() / 3, after = before + triangles.vertex_count();
  if (after >= TYN_NONE)
    fail(TYN_ERROR_FORMAT, "%s: the mesh has more vertices than 32-bit indices can name", piece.where.c_str());
  append_positions(triangles, world, mesh.positions, piece.where);
  append_normals(triangles, world, mesh.normals);
  if (!triangles.uvs.empty() || !mesh.uvs.empty()) {
    mesh.uvs.resize(2 * before, 0.0f); // what came before may have none
    mesh.uvs.insert(mesh.uvs.end(), triangles.uvs.begin(), triangles.uvs.end());
    mesh.uvs.resize(2 * after, 0.0f);
  }
  const bool mirrored = world.determinant() < 0;
  for (size_t t = 0; t < triangles.triangle_count(); t++) {
    for (const size_t corner : {size_t(0), size_t(mirrored ? 2 : 1), size_t(mirrored ? 1 : 2)})
      mesh.indices.push_back(uint32_t(before + triangles.indices[3 * t + corner]));
    mesh.triangle_materials.push_back(piece.use.material);
  }
}

} // namespace tyn::io
