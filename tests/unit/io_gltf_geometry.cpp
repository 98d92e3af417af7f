// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
// Accessors, primitives and nodes: what ends up in world space.
#ifdef TYN_TEST_IO
#include <cmath>
#include <cstring>

#include <gtest/gtest.h>
#include <meshoptimizer.h>

#include "common/gltf_builder.hpp"

using tyn_test::Gltf;
using tyn_test::load;
using tyn_test::Loading;
using Floats = std::vector<float>;
using Indices = std::vector<uint32_t>;

namespace {

const Floats TRIANGLE = {0, 0, 0, 1, 0, 0, 0, 1, 0};

Gltf triangle() {
  Gltf model = Gltf::one_primitive();
  model.primitive()["attributes"]["POSITION"] = model.floats(TRIANGLE, "VEC3");
  return model;
}

// Loads a model of one mesh.
tyn::io::LoadedMesh only_mesh(const Gltf &model) {
  const Loading loading = load(model);
  EXPECT_EQ(loading.status, TYN_OK) << loading.message;
  EXPECT_EQ(loading.scene.meshes.size(), 1u);
  return loading.scene.meshes.empty() ? tyn::io::LoadedMesh() : loading.scene.meshes[0];
}

void expect_near(const Floats &values, const Floats &expected, float tolerance = 1e-6f) {
  ASSERT_EQ(values.size(), expected.size());
  for (size_t i = 0; i < values.size(); i++)
    EXPECT_NEAR(values[i], expected[i], tolerance) << "element " << i;
}

// A strip or fan of 5 vertices.
Gltf with_mode(int mode) {
  Gltf model = Gltf::one_primitive();
  model.primitive()["attributes"]["POSITION"] = model.floats({0, 0, 0, 1, 0, 0, 2, 0, 0, 3, 0, 0, 4, 0, 0}, "VEC3");
  model.primitive()["mode"] = mode;
  return model;
}

// The x coordinates of the corners in the order of the triangles: which vertices were used.
Floats corner_xs(const tyn::io::LoadedMesh &mesh) {
  Floats result;
  for (const uint32_t index : mesh.indices)
    result.push_back(mesh.positions[3 * index]);
  return result;
}

} // namespace

TEST(GltfGeometry, AsciiAndGlbGiveTheSameMesh) {
  const Gltf model = Gltf::tetrahedron();
  const Loading ascii = load(model), glb = tyn_test::load_bytes(model.glb());
  ASSERT_EQ(ascii.status, TYN_OK) << ascii.message;
  ASSERT_EQ(glb.status, TYN_OK) << glb.message;
  ASSERT_EQ(ascii.scene.meshes.size(), 1u);
  EXPECT_EQ(ascii.scene.meshes[0].positions, glb.scene.meshes[0].positions);
  EXPECT_EQ(ascii.scene.meshes[0].indices, glb.scene.meshes[0].indices);
  EXPECT_EQ(glb.scene.meshes[0].indices.size(), 12u);
  EXPECT_EQ(glb.scene.meshes[0].name, "node");
  EXPECT_TRUE(glb.warnings.empty());
}

TEST(GltfGeometry, ExternalBufferIsReadFromTheModelsFolderWithPercentEncodingUndone) {
  Gltf model = triangle();
  model.json["buffers"] = {{{"byteLength", model.data.size()}, {"uri", "a%20b.bin"}}};
  const tyn_test::TemporaryFolder folder;
  folder.write("a b.bin", model.data);
  folder.write("model.gltf", model.ascii());
  const Loading loading = tyn_test::load_file(folder.file("model.gltf"));
  ASSERT_EQ(loading.status, TYN_OK) << loading.message;
  EXPECT_EQ(loading.scene.meshes[0].positions, TRIANGLE);
}

TEST(GltfGeometry, PrimitiveWithoutIndicesDrawsItsVerticesInOrder) {
  const tyn::io::LoadedMesh mesh = only_mesh(triangle());
  EXPECT_EQ(mesh.positions, TRIANGLE);
  EXPECT_EQ(mesh.indices, Indices({0, 1, 2}));
  EXPECT_TRUE(mesh.normals.empty());
  EXPECT_TRUE(mesh.uvs.empty());
}

TEST(GltfGeometry, IndicesOfEveryWidthAreRead) {
  for (const int type : {5121, 5123, 5125}) {
    Gltf model = triangle();
    const int view = type == 5121   ? model.view(std::vector<uint8_t>{2, 1, 0})
                     : type == 5123 ? model.view(std::vector<uint16_t>{2, 1, 0})
                                    : model.view(std::vector<uint32_t>{2, 1, 0});
    model.primitive()["indices"] = model.accessor(view, type, 3, "SCALAR");
    EXPECT_EQ(corner_xs(only_mesh(model)), Floats({0, 1, 0})) << type;
  }
}

TEST(GltfGeometry, StripsAndFansBecomeTrianglesOfTheSameOrientation) {
  EXPECT_EQ(corner_xs(only_mesh(with_mode(5))), Floats({0, 1, 2, 1, 3, 2, 2, 3, 4}));
  EXPECT_EQ(corner_xs(only_mesh(with_mode(6))), Floats({1, 2, 0, 2, 3, 0, 3, 4, 0}));
}

TEST(GltfGeometry, PointsAndLinesAreIgnoredWithAWarning) {
  for (const int mode : {0, 1, 2, 3}) {
    const Loading loading = load(with_mode(mode));
    EXPECT_EQ(loading.status, TYN_OK) << loading.message;
    EXPECT_TRUE(loading.scene.meshes.empty());
    EXPECT_TRUE(loading.warned(mode == 0 ? "draws points" : "draws lines"));
    EXPECT_TRUE(loading.warned("no triangles"));
  }
}

TEST(GltfGeometry, UnusedVerticesOfASharedAccessorAreDropped) {
  Gltf model = with_mode(4);
  model.primitive()["indices"] = model.indices({4, 3, 1});
  const tyn::io::LoadedMesh mesh = only_mesh(model);
  EXPECT_EQ(mesh.positions.size(), 9u);
  EXPECT_EQ(corner_xs(mesh), Floats({4, 3, 1}));
}

TEST(GltfGeometry, StrideAndOffsetsAreFollowed) {
  // Position and texture coordinate interleaved, after a word that belongs to neither.
  const Floats interleaved = {99, 0, 0, 0, 5, 6, 1, 0, 0, 7, 8, 0, 1, 0, 9, 10};
  Gltf model = Gltf::one_primitive();
  const int view = model.view(interleaved, 20);
  model.primitive()["attributes"]["POSITION"] = model.accessor(view, 5126, 3, "VEC3");
  model.primitive()["attributes"]["TEXCOORD_0"] = model.accessor(view, 5126, 3, "VEC2");
  model.json["accessors"][0]["byteOffset"] = 4;
  model.json["accessors"][1]["byteOffset"] = 16;
  const tyn::io::LoadedMesh mesh = only_mesh(model);
  EXPECT_EQ(mesh.positions, TRIANGLE);
  EXPECT_EQ(mesh.uvs, Floats({5, 6, 7, 8, 9, 10}));
}

TEST(GltfGeometry, NormalizedIntegersBecomeFractions) {
  Gltf model = triangle();
  const int bytes = model.view(std::vector<uint8_t>{0, 255, 51, 102, 255, 0});
  model.primitive()["attributes"]["TEXCOORD_0"] = model.accessor(bytes, 5121, 3, "VEC2");
  model.json["accessors"][1]["normalized"] = true;
  expect_near(only_mesh(model).uvs, {0, 1, 0.2f, 0.4f, 1, 0});
  Gltf shorts = triangle();
  const int words = shorts.view(std::vector<int16_t>{32767, 0, 0, 0, -32768, 0, 0, 0, -32767});
  shorts.primitive()["attributes"]["NORMAL"] = shorts.accessor(words, 5122, 3, "VEC3");
  shorts.json["accessors"][1]["normalized"] = true;
  expect_near(only_mesh(shorts).normals, {1, 0, 0, 0, -1, 0, 0, 0, -1});
}

TEST(GltfGeometry, QuantizedPositionsKeepTheirIntegerValues) {
  Gltf model = Gltf::one_primitive();
  const int view = model.view(std::vector<uint16_t>{0, 0, 0, 0, 1000, 0, 0, 0, 0, 65535, 0, 0}, 8);
  model.primitive()["attributes"]["POSITION"] = model.accessor(view, 5123, 3, "VEC3");
  model.json["nodes"][0]["scale"] = {0.001, 0.001, 0.001};
  model.json["extensionsRequired"] = {"KHR_mesh_quantization"};
  expect_near(only_mesh(model).positions, {0, 0, 0, 1, 0, 0, 0, 65.535f, 0}, 1e-5f);
}

TEST(GltfGeometry, SparseAccessorReplacesElements) {
  Gltf model = triangle();
  const int positions = model.view(std::vector<uint16_t>{2});
  const int values = model.view(Floats{7, 8, 9});
  model.json["accessors"][0]["sparse"] = {{"count", 1},
                                          {"indices", {{"bufferView", positions}, {"componentType", 5123}}},
                                          {"values", {{"bufferView", values}}}};
  EXPECT_EQ(only_mesh(model).positions, Floats({0, 0, 0, 1, 0, 0, 7, 8, 9}));
}

TEST(GltfGeometry, SparseAccessorWithoutABufferViewStartsFromZeros) {
  Gltf model = Gltf::one_primitive();
  const int positions = model.view(std::vector<uint8_t>{1, 2});
  const int values = model.view(Floats{1, 0, 0, 0, 1, 0});
  model.primitive()["attributes"]["POSITION"] = model.accessor(-1, 5126, 3, "VEC3");
  model.json["accessors"][0]["sparse"] = {{"count", 2},
                                          {"indices", {{"bufferView", positions}, {"componentType", 5121}}},
                                          {"values", {{"bufferView", values}}}};
  EXPECT_EQ(only_mesh(model).positions, TRIANGLE);
}

namespace {

// Replaces a buffer view's bytes by compressed ones in a buffer of their own, and its buffer by one without data.
void compress(Gltf &model, size_t view, const std::string &bytes, size_t stride, size_t count, const char *mode,
              const char *filter, const char *name) {
  nlohmann::json &entry = model.json["bufferViews"][view];
  const size_t offset = model.data.size();
  model.data += bytes;
  entry["buffer"] = 1;
  entry["byteOffset"] = 0;
  entry["extensions"][name] = {{"buffer", 0},          {"byteOffset", offset}, {"byteLength", bytes.size()},
                               {"byteStride", stride}, {"count", count},       {"mode", mode},
                               {"filter", filter}};
  model.json["buffers"] = {{{"byteLength", model.data.size()},
                            {"uri", "data:application/octet-stream;base64," + tyn_test::base64(model.data)}},
                           {{"byteLength", 1000}, {"extensions", {{name, {{"fallback", true}}}}}}};
}

std::string encode_vertices(const void *vertices, size_t count, size_t size) {
  std::string bytes(meshopt_encodeVertexBufferBound(count, size), '\0');
  bytes.resize(
      meshopt_encodeVertexBuffer(reinterpret_cast<unsigned char *>(&bytes[0]), bytes.size(), vertices, count, size));
  return bytes;
}

} // namespace

TEST(GltfGeometry, MeshoptCompressionIsUndoneUnderBothNames) {
  meshopt_encodeVertexVersion(0);
  meshopt_encodeIndexVersion(1);
  for (const char *name : {"EXT_meshopt_compression", "KHR_meshopt_compression"}) {
    Gltf model = Gltf::tetrahedron();
    const tyn::io::LoadedMesh plain = only_mesh(model);
    const Floats positions = {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1};
    const Indices indices = {0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3};
    std::string triangles(meshopt_encodeIndexBufferBound(12, 4), '\0');
    triangles.resize(meshopt_encodeIndexBuffer(reinterpret_cast<unsigned char *>(&triangles[0]), triangles.size(),
                                               indices.data(), 12));
    model.data.clear();
    compress(model, 0, encode_vertices(positions.data(), 4, 12), 12, 4, "ATTRIBUTES", "NONE", name);
    compress(model, 1, triangles, 4, 12, "TRIANGLES", "NONE", name);
    model.json["extensionsRequired"] = {name};
    const tyn::io::LoadedMesh mesh = only_mesh(model);
    ASSERT_EQ(mesh.indices.size(), 12u);
    // The encoder may turn the corners of a triangle and the order of triangles, not their set of areas and volume.
    double volume = 0;
    for (size_t t = 0; t < 12; t += 3) {
      const float *a = &mesh.positions[3 * mesh.indices[t]], *b = &mesh.positions[3 * mesh.indices[t + 1]],
                  *c = &mesh.positions[3 * mesh.indices[t + 2]];
      volume += (a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) +
                 a[2] * (b[0] * c[1] - b[1] * c[0])) /
                6;
    }
    EXPECT_NEAR(volume, 1 / 6.0, 1e-6);
    EXPECT_EQ(mesh.positions.size(), plain.positions.size());
  }
}

TEST(GltfGeometry, MeshoptIndexSequenceIsDecoded) {
  Gltf model = Gltf::one_primitive();
  model.primitive()["attributes"]["POSITION"] = model.floats(TRIANGLE, "VEC3");
  model.primitive()["indices"] = model.indices({2, 0, 1});
  const Indices indices = {2, 0, 1};
  std::string bytes(meshopt_encodeIndexSequenceBound(3, 3), '\0');
  bytes.resize(
      meshopt_encodeIndexSequence(reinterpret_cast<unsigned char *>(&bytes[0]), bytes.size(), indices.data(), 3));
  compress(model, 1, bytes, 4, 3, "INDICES", "NONE", "EXT_meshopt_compression");
  EXPECT_EQ(corner_xs(only_mesh(model)), Floats({0, 0, 1}));
}

TEST(GltfGeometry, MeshoptFiltersAreUndone) {
  meshopt_encodeVertexVersion(0);
  const Floats normals = {1, 0, 0, 0, 0, 0, 1, 0, 0.6f, 0, 0.8f, 0};
  std::vector<int8_t> octahedral(12);
  meshopt_encodeFilterOct(octahedral.data(), 3, 4, 8, normals.data());
  Gltf model = triangle();
  const int view = model.view(std::vector<int8_t>(12), 4);
  model.primitive()["attributes"]["NORMAL"] = model.accessor(view, 5120, 3, "VEC3");
  model.json["accessors"][1]["normalized"] = true;
  compress(model, size_t(view), encode_vertices(octahedral.data(), 3, 4), 4, 3, "ATTRIBUTES", "OCTAHEDRAL",
           "EXT_meshopt_compression");
  expect_near(only_mesh(model).normals, {1, 0, 0, 0, 0, 1, 0.6f, 0, 0.8f}, 0.02f);

  // Exponent in the upper 8 bits, mantissa in the lower 24: 2^-1 x 2 and 2^0 x 1.
  const std::vector<uint32_t> exponential = {0, 0, 0, 0xff000002, 0, 0, 0, 1, 0};
  Gltf positions = triangle();
  compress(positions, 0, encode_vertices(exponential.data(), 3, 12), 12, 3, "ATTRIBUTES", "EXPONENTIAL",
           "EXT_meshopt_compression");
  EXPECT_EQ(only_mesh(positions).positions, TRIANGLE);
}

TEST(GltfGeometry, NodesAreBakedIntoWorldSpace) {
  Gltf model = triangle();
  model.primitive()["attributes"]["NORMAL"] = model.floats({0, 0, 1, 0, 0, 1, 0, 0, 1}, "VEC3");
  // A quarter turn about z within a translation; the child doubles x.
  model.json["nodes"] = {
      {{"children", {1}}, {"translation", {10, 0, 0}}, {"rotation", {0, 0, std::sqrt(0.5), std::sqrt(0.5)}}},
      {{"mesh", 0}, {"scale", {2, 1, 1}}}};
  const tyn::io::LoadedMesh mesh = only_mesh(model);
  expect_near(mesh.positions, {10, 0, 0, 10, 2, 0, 9, 0, 0});
  expect_near(mesh.normals, {0, 0, 1, 0, 0, 1, 0, 0, 1});
  EXPECT_EQ(mesh.name, "mesh"); // the node has none
}

TEST(GltfGeometry, MatrixOfANodeIsColumnMajor) {
  Gltf model = triangle();
  model.json["nodes"][0]["matrix"] = {0, 1, 0, 0, -1, 0, 0, 0, 0, 0, 1, 0, 3, 4, 5, 1};
  expect_near(only_mesh(model).positions, {3, 4, 5, 3, 5, 5, 2, 4, 5});
}

TEST(GltfGeometry, NormalsFollowTheInverseTranspose) {
  Gltf model = triangle();
  const float s = std::sqrt(0.5f);
  model.primitive()["attributes"]["NORMAL"] = model.floats({s, s, 0, 0, 0, 1, s, 0, s}, "VEC3");
  model.json["nodes"][0]["scale"] = {2, 1, 1};
  // (1, 1, 0) becomes (1/2, 1, 0), and so on.
  const float a = 1 / std::sqrt(5.0f);
  expect_near(only_mesh(model).normals, {a, 2 * a, 0, 0, 0, 1, a, 0, 2 * a});
}

TEST(GltfGeometry, MirroringNodeTurnsTheWinding) {
  Gltf model = Gltf::tetrahedron();
  model.json["nodes"][0]["scale"] = {-1, 1, 1};
  const tyn::io::LoadedMesh mesh = only_mesh(model);
  double volume = 0;
  for (size_t t = 0; t < mesh.indices.size(); t += 3) {
    const float *a = &mesh.positions[3 * mesh.indices[t]], *b = &mesh.positions[3 * mesh.indices[t + 1]],
                *c = &mesh.positions[3 * mesh.indices[t + 2]];
    volume +=
        a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) + a[2] * (b[0] * c[1] - b[1] * c[0]);
  }
  EXPECT_NEAR(volume / 6, 1 / 6.0, 1e-6);
  Gltf normals = triangle();
  normals.primitive()["attributes"]["NORMAL"] = normals.floats({1, 0, 0, 0, 0, 1, 0, 1, 0}, "VEC3");
  normals.json["nodes"][0]["scale"] = {-1, 1, 1};
  expect_near(only_mesh(normals).normals, {-1, 0, 0, 0, 0, 1, 0, 1, 0});
}

TEST(GltfGeometry, MeshOnTwoNodesIsTwoObjects) {
  Gltf model = triangle();
  model.json["nodes"] = {{{"mesh", 0}}, {{"mesh", 0}, {"translation", {0, 0, 1}}}};
  model.json["scenes"] = {{{"nodes", {0, 1}}}};
  const Loading loading = load(model);
  ASSERT_EQ(loading.scene.meshes.size(), 2u);
  expect_near(loading.scene.meshes[1].positions, {0, 0, 1, 1, 0, 1, 0, 1, 1});
}

TEST(GltfGeometry, DefaultSceneIsTheChosenOneThenTheFirstThenAllRoots) {
  Gltf model = triangle();
  model.json["nodes"] = {{{"mesh", 0}, {"name", "a"}}, {{"mesh", 0}, {"name", "b"}}};
  model.json["scenes"] = {{{"nodes", {0}}}, {{"nodes", {1}}}};
  model.json["scene"] = 1;
  EXPECT_EQ(only_mesh(model).name, "b");
  model.json.erase("scene");
  EXPECT_EQ(only_mesh(model).name, "a");
  model.json.erase("scenes");
  EXPECT_EQ(load(model).scene.meshes.size(), 2u);
}

TEST(GltfGeometry, DeepHierarchyIsWalkedWithoutRecursion) {
  Gltf model = triangle();
  const int depth = 50000;
  model.json["nodes"] = nlohmann::json::array();
  for (int i = 0; i < depth; i++)
    model.json["nodes"].push_back({{"children", {i + 1}}});
  model.json["nodes"].push_back({{"mesh", 0}});
  EXPECT_EQ(only_mesh(model).positions, TRIANGLE);
}

TEST(GltfGeometry, PrimitivesOfOneMediumAreOneMeshWithAMaterialForEachTriangle) {
  Gltf model = triangle();
  model.primitive()["attributes"]["TEXCOORD_0"] = model.floats({1, 2, 3, 4, 5, 6}, "VEC2");
  model.json["materials"].push_back({{"name", "other"}});
  nlohmann::json second = model.primitive();
  second["material"] = 1;
  second["attributes"].erase("TEXCOORD_0");
  model.json["meshes"][0]["primitives"].push_back(second);
  const tyn::io::LoadedMesh mesh = only_mesh(model);
  EXPECT_EQ(mesh.triangle_materials, Indices({0, 1}));
  EXPECT_EQ(mesh.uvs, Floats({1, 2, 3, 4, 5, 6, 0, 0, 0, 0, 0, 0}));
}

TEST(GltfGeometry, PrimitiveWithoutNormalsBesideOneWithNormalsIsShadedFlat) {
  Gltf model = triangle();
  nlohmann::json second = model.primitive();
  model.primitive()["attributes"]["NORMAL"] = model.floats({1, 0, 0, 1, 0, 0, 1, 0, 0}, "VEC3");
  model.json["meshes"][0]["primitives"].push_back(second);
  const Loading loading = load(model);
  EXPECT_TRUE(loading.warnings.empty());
  expect_near(loading.scene.meshes[0].normals, {1, 0, 0, 1, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 1, 0, 0, 1});
}

TEST(GltfGeometry, UnusableNormalsAreReplacedWithAWarning) {
  Gltf model = triangle();
  model.primitive()["attributes"]["NORMAL"] = model.floats({0, 0, 0, NAN, 0, 0, 0, 1, 0}, "VEC3");
  const Loading loading = load(model);
  expect_near(loading.scene.meshes[0].normals, {0, 0, 1, 0, 0, 1, 0, 1, 0});
  EXPECT_TRUE(loading.warned("2 normals"));
}

TEST(GltfGeometry, SkinsMorphTargetsAndVertexColoursAreWarnedAbout) {
  Gltf model = triangle();
  model.json["skins"] = {{{"joints", {0}}}};
  model.json["nodes"][0]["skin"] = 0;
  model.primitive()["targets"] = {{{"POSITION", 0}}};
  model.primitive()["attributes"]["COLOR_0"] = 0;
  const Loading loading = load(model);
  EXPECT_EQ(loading.status, TYN_OK) << loading.message;
  EXPECT_TRUE(loading.warned("skinned"));
  EXPECT_TRUE(loading.warned("morph"));
  EXPECT_TRUE(loading.warned("vertex colours"));
}

TEST(GltfGeometry, OptionalUnknownExtensionIsAWarning) {
  Gltf model = triangle();
  model.json["extensionsUsed"] = {"VENDOR_anything"};
  const Loading loading = load(model);
  EXPECT_EQ(loading.status, TYN_OK);
  EXPECT_TRUE(loading.warned("VENDOR_anything"));
}

TEST(GltfGeometry, IntegersWrittenAsFloatsAreAccepted) {
  Gltf model = triangle();
  model.json["accessors"][0]["count"] = 3.0;
  EXPECT_EQ(only_mesh(model).positions, TRIANGLE);
}
#endif
