// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
// Broken and hostile glTF files: each has its status and one line that says what is wrong where.
#ifdef TYN_TEST_IO
#include <cmath>

#include <gtest/gtest.h>
#include <meshoptimizer.h>

#include "common/gltf_builder.hpp"
#include "io/gltf_accessor.hpp"

using tyn_test::Gltf;
using tyn_test::Loading;

namespace {

// Expects a failure whose message is one line that holds `part`.
void expect_failure(const Loading &loading, TynStatus status, const std::string &part) {
  EXPECT_EQ(loading.status, status) << loading.message;
  EXPECT_NE(loading.message.find(part), std::string::npos) << loading.message;
  EXPECT_EQ(loading.message.find('\n'), std::string::npos) << loading.message;
}

void expect_format(const Gltf &model, const std::string &part) {
  expect_failure(tyn_test::load(model), TYN_ERROR_FORMAT, part);
}

// A tetrahedron with `value` written over the JSON at `pointer`.
Gltf changed(const char *pointer, const nlohmann::json &value) {
  Gltf model = Gltf::tetrahedron();
  model.json[nlohmann::json::json_pointer(pointer)] = value;
  return model;
}

Gltf with_texture(const std::string &image) {
  Gltf model = Gltf::tetrahedron();
  const int view = model.view_of_bytes(image);
  model.json["images"] = {{{"bufferView", view}}};
  model.json["textures"] = {{{"source", 0}}};
  model.material()["pbrMetallicRoughness"]["baseColorTexture"] = {{"index", 0}};
  return model;
}

Gltf with_sparse(uint16_t index, int count = 1) {
  Gltf model = Gltf::tetrahedron();
  const int indices = model.view(std::vector<uint16_t>{index, 0});
  const int values = model.view(std::vector<float>{7, 8, 9});
  model.json["accessors"][0]["sparse"] = {{"count", count},
                                          {"indices", {{"bufferView", indices}, {"componentType", 5123}}},
                                          {"values", {{"bufferView", values}}}};
  return model;
}

Gltf with_meshopt(const nlohmann::json &changes) {
  Gltf model = Gltf::tetrahedron();
  const std::vector<float> positions(12, 1.0f);
  std::string bytes(meshopt_encodeVertexBufferBound(4, 12), '\0');
  meshopt_encodeVertexVersion(0);
  bytes.resize(
      meshopt_encodeVertexBuffer(reinterpret_cast<unsigned char *>(&bytes[0]), bytes.size(), positions.data(), 4, 12));
  const size_t offset = model.data.size();
  model.data += bytes;
  nlohmann::json extension = {{"buffer", 0},      {"byteOffset", offset}, {"byteLength", bytes.size()},
                              {"byteStride", 12}, {"count", 4},           {"mode", "ATTRIBUTES"}};
  extension.update(changes);
  model.json["bufferViews"][0]["extensions"]["EXT_meshopt_compression"] = extension;
  return model;
}

} // namespace

TEST(BadGltf, MissingFileAndFolderAreFileErrors) {
  const tyn_test::TemporaryFolder folder;
  expect_failure(tyn_test::load_file(folder.file("none.glb")), TYN_ERROR_FILE, "none.glb: No such file");
  expect_failure(tyn_test::load_file(folder.path), TYN_ERROR_FILE, "it is a folder");
}

TEST(BadGltf, TextThatIsNotGltfIsAFormatError) {
  for (const char *text : {"", "x", "{", "[]", "{}", "null", "glTF", "{\"asset\": 1}", "{\"asset\": {}}", "\xff\xfe{}"})
    EXPECT_EQ(tyn_test::load_bytes(text).status, TYN_ERROR_FORMAT) << text;
  expect_failure(tyn_test::load_bytes("{\"asset\": }"), TYN_ERROR_FORMAT, "line 1");
}

TEST(BadGltf, OtherVersionsAreRefused) {
  expect_format(changed("/asset/version", "1.0"), "only glTF 2.x");
  expect_format(changed("/asset/minVersion", "3.0"), "asset.minVersion");
}

TEST(BadGltf, GlbCutOffAnywhereIsAFormatError) {
  const std::string whole = Gltf::tetrahedron().glb();
  ASSERT_EQ(tyn_test::load_bytes(whole).status, TYN_OK);
  for (size_t length = 0; length < whole.size(); length++) {
    const Loading loading = tyn_test::load_bytes(whole.substr(0, length));
    EXPECT_EQ(loading.status, TYN_ERROR_FORMAT) << length;
    EXPECT_EQ(loading.message.find('\n'), std::string::npos) << loading.message;
  }
}

TEST(BadGltf, GlbWhoseHeadersLieIsAFormatError) {
  const std::string whole = Gltf::tetrahedron().glb();
  for (const size_t at : {size_t(4), size_t(8), size_t(12), size_t(16)}) { // version, length, chunk size, chunk type
    for (const unsigned char value : {0x00, 0x01, 0x7f, 0xff}) {
      std::string broken = whole;
      broken.replace(at, 4, 4, char(value));
      EXPECT_EQ(tyn_test::load_bytes(broken).status, TYN_ERROR_FORMAT) << at << " " << int(value);
    }
  }
}

TEST(BadGltf, EveryFlippedByteIsSurvived) {
  const std::string whole = Gltf::tetrahedron().glb();
  for (size_t i = 0; i < whole.size(); i++)
    for (const int bit : {0, 3, 7}) {
      std::string broken = whole;
      broken[i] = char(broken[i] ^ (1 << bit));
      const Loading loading = tyn_test::load_bytes(broken);
      EXPECT_TRUE(loading.status == TYN_OK || loading.status == TYN_ERROR_FORMAT || loading.status == TYN_ERROR_FILE)
          << i << ": " << loading.message;
    }
}

TEST(BadGltf, JsonNestedTooDeeplyIsRefused) {
  const std::string deep(200000, '[');
  expect_failure(tyn_test::load_bytes("{\"extras\": " + deep), TYN_ERROR_FORMAT, "nested");
}

TEST(BadGltf, WrongTypesAreNamedWithTheirPath) {
  expect_format(changed("/nodes", 5), "nodes is 5; it must be an array");
  expect_format(changed("/nodes/0", "x"), "nodes[0] is \"x\"; it must be an object");
  expect_format(changed("/nodes/0/translation", {1, 2}), "nodes[0].translation");
  expect_format(changed("/nodes/0/matrix", {1, 2, 3}), "array of 16 numbers");
  expect_format(changed("/accessors/0/count", -1), "accessors[0].count is -1");
  expect_format(changed("/accessors/0/count", 1.5), "accessors[0].count is 1.5");
  expect_format(changed("/accessors/0/byteOffset", -4), "accessors[0].byteOffset is -4");
  expect_format(changed("/bufferViews/0/byteOffset", -4), "bufferViews[0].byteOffset is -4");
  expect_format(changed("/bufferViews/0/byteStride", 1000), "bufferViews[0].byteStride is 1000");
  expect_format(changed("/materials/0/extensions/KHR_materials_ior", {{"ior", "high"}}),
                "materials[0].extensions.KHR_materials_ior.ior");
  expect_format(changed("/meshes/0/primitives/0/mode", 7), "mode is 7");
  Gltf model = Gltf::tetrahedron();
  model.json["accessors"][0].erase("count");
  expect_format(model, "accessors[0].count is missing");
}

TEST(BadGltf, IndicesOfElementsThatDoNotExistAreNamedWithTheirPath) {
  expect_format(changed("/scene", 1), "scene is 1; it must be an index into scenes, which has 1 elements");
  expect_format(changed("/scenes/0/nodes/0", 9), "scenes[0].nodes[0] is 9");
  expect_format(changed("/nodes/0/mesh", 1), "nodes[0].mesh is 1");
  expect_format(changed("/nodes/0/mesh", -1), "nodes[0].mesh is -1");
  expect_format(changed("/nodes/0/camera", 0), "nodes[0].camera is 0");
  expect_format(changed("/nodes/0/extensions/KHR_lights_punctual/light", 0), "light is 0");
  expect_format(changed("/meshes/0/primitives/0/material", 3), "material is 3");
  expect_format(changed("/meshes/0/primitives/0/indices", 99), "indices is 99");
  expect_format(changed("/meshes/0/primitives/0/attributes/POSITION", 99), "attributes.POSITION is 99");
  expect_format(changed("/accessors/0/bufferView", 99), "accessors[0].bufferView is 99");
  expect_format(changed("/bufferViews/0/buffer", 99), "bufferViews[0].buffer is 99");
  expect_format(changed("/materials/0/normalTexture", {{"index", 0}}), "materials[0].normalTexture.index is 0");
}

TEST(BadGltf, AccessorBeyondItsBufferViewIsRefused) {
  expect_format(changed("/accessors/0/count", 5), "do not fit into the 48 bytes of bufferViews[0]");
  expect_format(changed("/accessors/0/byteOffset", 4), "meshes[0].primitives[0].attributes.POSITION (accessors[0])");
  expect_format(changed("/accessors/0/byteOffset", 9007199254740991), "do not fit");
  expect_format(changed("/accessors/0/count", 4294967295), "elements");
  expect_format(changed("/bufferViews/0/byteLength", 100000), "bufferViews[0] covers 100000 bytes");
  expect_format(changed("/bufferViews/0/byteOffset", 9007199254740991), "bufferViews[0] covers");
  expect_format(changed("/bufferViews/0/byteStride", 4), "byteStride is 4");
}

TEST(BadGltf, SizesNearOverflowNeverFit) {
  constexpr uint64_t HUGE_SIZE = UINT64_MAX;
  EXPECT_TRUE(tyn::io::elements_fit(4, 16, 3, 12, 48));
  EXPECT_FALSE(tyn::io::elements_fit(5, 16, 3, 12, 48));
  EXPECT_TRUE(tyn::io::elements_fit(48, 16, 0, 12, 48));
  EXPECT_FALSE(tyn::io::elements_fit(49, 16, 0, 12, 48));
  EXPECT_FALSE(tyn::io::elements_fit(0, HUGE_SIZE, HUGE_SIZE, 1, 100));
  EXPECT_FALSE(tyn::io::elements_fit(HUGE_SIZE, 1, 2, 1, 100));
  EXPECT_FALSE(tyn::io::elements_fit(HUGE_SIZE - 1, 1, 1, 12, 100));
  EXPECT_FALSE(tyn::io::elements_fit(0, uint64_t(1) << 32, uint64_t(1) << 32, 1, 100));
}

TEST(BadGltf, AccessorWithoutDataCannotFillTheMemory) {
  Gltf model = changed("/accessors/0/count", 4000000000u);
  model.json["accessors"][0].erase("bufferView");
  expect_format(model, "elements");
  model.json["accessors"][0]["count"] = 100000000;
  expect_format(model, "no bufferView");
}

TEST(BadGltf, VertexIndexOutOfRangeIsNamed) {
  Gltf model = Gltf::tetrahedron();
  model.primitive()["indices"] = model.indices({0, 1, 4});
  expect_format(model, "element 2 is 4, but there are 4 vertices");
}

TEST(BadGltf, PositionThatIsNotFiniteIsNamed) {
  for (const float value : {NAN, INFINITY}) {
    Gltf model = Gltf::tetrahedron();
    model.primitive()["attributes"]["POSITION"] = model.floats({0, 0, 0, 1, 0, value, 0, 1, 0, 0, 0, 1}, "VEC3");
    expect_format(model, "element 1 is");
  }
  expect_format(changed("/nodes/0/scale", {1e39, 1, 1}), "too far out");
  expect_format(changed("/nodes/0/translation", {1e308, 1e308, 1e308}), "too far out");
}

TEST(BadGltf, PositionBeyondTheScenesLimitIsNamed) {
  expect_format(changed("/nodes/0/translation", {0, 1.1e10, 0}),
                "meshes[0].primitives[0]: vertex 0 lies at 0 1.1e+10 0");
  expect_format(changed("/nodes/0/scale", {-2e10, 1, 1}), "coordinates reach to 1e+10");
  Gltf model = Gltf::tetrahedron();
  model.primitive()["attributes"]["POSITION"] = model.floats({0, 0, 0, 2e10f, 0, 0, 0, 1, 0, 0, 0, 1}, "VEC3");
  expect_format(model, "too far out");
  model.json["nodes"][0]["scale"] = {0.5, 1, 1}; // back inside
  EXPECT_EQ(tyn_test::load(model).status, TYN_OK);
}

TEST(BadGltf, PrimitiveOfFewerThanThreeVerticesIsIgnored) {
  Gltf model = Gltf::tetrahedron();
  nlohmann::json second = model.primitive();
  for (const std::vector<uint32_t> &indices : {std::vector<uint32_t>{0, 0, 0}, {2, 3, 2, 3, 3, 2}}) {
    second["indices"] = model.indices(indices);
    model.json["meshes"][0]["primitives"][1] = second;
    const Loading loading = tyn_test::load(model);
    ASSERT_EQ(loading.status, TYN_OK) << loading.message;
    EXPECT_TRUE(loading.warned("meshes[0].primitives[1] has only triangles that repeat a vertex"));
    ASSERT_EQ(loading.scene.meshes.size(), 1u);
    EXPECT_EQ(loading.scene.meshes[0].indices.size(), 12u);
  }
  model.json["meshes"][0]["primitives"] = {second};
  const Loading nothing = tyn_test::load(model);
  EXPECT_EQ(nothing.status, TYN_OK) << nothing.message;
  EXPECT_TRUE(nothing.scene.meshes.empty());
  EXPECT_TRUE(nothing.warned("the scene has no triangles"));
}

TEST(BadGltf, AttributesOfDifferentLengthsAreRefused) {
  Gltf model = Gltf::tetrahedron();
  model.primitive()["attributes"]["NORMAL"] = model.floats({0, 0, 1}, "VEC3");
  expect_format(model, "has 1 elements, but POSITION has 4");
}

TEST(BadGltf, AttributeOfTheWrongTypeIsRefused) {
  expect_format(changed("/accessors/0/type", "VEC2"), "it must be VEC3");
  expect_format(changed("/accessors/1/type", "VEC2"), "it must be SCALAR");
  expect_format(changed("/accessors/1/componentType", 5126), "must be an unsigned integer");
}

TEST(BadGltf, SparseAccessorOutOfRangeIsRefused) {
  EXPECT_EQ(tyn_test::load(with_sparse(3)).status, TYN_OK);
  expect_format(with_sparse(4), "sparse.indices: element 0 is 4, but the accessor has 4 elements");
  expect_format(with_sparse(0, 3), "sparse.indices");
  expect_format(with_sparse(0, 2), "sparse.values");
  Gltf model = with_sparse(0);
  model.json["accessors"][0]["sparse"]["indices"]["componentType"] = 5126;
  expect_format(model, "must be an unsigned integer");
}

TEST(BadGltf, NodeCyclesAndSharedChildrenAreRefused) {
  Gltf model = changed("/nodes", {{{"children", {1}}}, {{"children", {0}}}});
  expect_format(model, "in a cycle");
  model.json["nodes"] = {{{"children", {0}}}};
  expect_format(model, "in a cycle");
  model.json.erase("scenes");
  model.json.erase("scene");
  expect_format(model, "in a cycle");
  model.json["nodes"] = {{{"children", {2}}}, {{"children", {2}}}, {{"mesh", 0}}};
  expect_format(model, "nodes[2] is a child of nodes[0] and again of nodes[1]");
  model.json["nodes"] = {{{"children", {1}}}, {{"mesh", 0}}};
  model.json["scenes"] = {{{"nodes", {1}}}};
  expect_format(model, "is no root");
  model.json["scenes"] = {{{"nodes", {0, 0}}}};
  expect_format(model, "twice");
}

TEST(BadGltf, RequiredExtensionThatIsNotSupportedIsNamed) {
  expect_format(changed("/extensionsRequired", {"KHR_materials_ior", "VENDOR_magic"}),
                "requires the extension VENDOR_magic");
  expect_format(changed("/extensionsRequired", {"KHR_draco_mesh_compression"}), "without compression");
  Gltf model = Gltf::tetrahedron();
  model.primitive()["extensions"]["KHR_draco_mesh_compression"] = {{"bufferView", 0}};
  EXPECT_EQ(tyn_test::load(model).status, TYN_OK); // there is ordinary data beside it
  model.json["accessors"][0].erase("bufferView");
  expect_format(model, "KHR_draco_mesh_compression");
}

TEST(BadGltf, PathsThatLeaveTheModelsFolderAreRefused) {
  for (const char *uri : {"../secret.bin", "a/../../secret.bin", "/etc/passwd", "file:///etc/passwd",
                          "http://host/x.bin", "%2e%2e/secret.bin", "..", "a\\b.bin", "C:/x.bin", "%00"}) {
    Gltf model = Gltf::tetrahedron();
    model.json["buffers"] = {{{"byteLength", model.data.size()}, {"uri", uri}}};
    expect_format(model, "buffers[0].uri");
  }
}

TEST(BadGltf, BuffersThatAreMissingShortOrDamagedAreRefused) {
  Gltf model = Gltf::tetrahedron();
  model.json["buffers"] = {{{"byteLength", model.data.size()}, {"uri", "gone.bin"}}};
  expect_failure(tyn_test::load(model), TYN_ERROR_FILE, "gone.bin: No such file");
  model.json["buffers"] = {{{"byteLength", model.data.size()}}};
  expect_format(model, "which has no uri");
  model.json["buffers"] = {{{"byteLength", 10}, {"uri", "data:application/octet-stream;base64,AAAA"}}};
  expect_format(model, "buffers[0].byteLength is 10, but its data has 3 bytes");
  model.json["buffers"] = {{{"byteLength", 3}, {"uri", "data:application/octet-stream;base64,A*AA"}}};
  expect_format(model, "not base64");
  model.json["buffers"] = {{{"byteLength", 3}, {"uri", "data:text/plain,abc"}}};
  expect_format(model, "not base64");
}

TEST(BadGltf, FilesBuffersAndTrianglesOverTheLimitsAreRefused) {
  TynGltfOptions options = tyn_gltf_options();
  options.max_triangles = 3;
  expect_failure(tyn_test::load(Gltf::tetrahedron(), options), TYN_ERROR_FORMAT, "more than 3 triangles");
  options = tyn_gltf_options();
  options.max_file_bytes = 100;
  expect_failure(tyn_test::load(Gltf::tetrahedron(), options), TYN_ERROR_FILE, "at most 100 are read");
  Gltf model = Gltf::tetrahedron();
  const tyn_test::TemporaryFolder folder;
  folder.write("data.bin", std::string(5000, 'x'));
  model.json["buffers"] = {{{"byteLength", 5000}, {"uri", "data.bin"}}};
  folder.write("model.gltf", model.ascii());
  options.max_file_bytes = 4000;
  expect_failure(tyn_test::load_file(folder.file("model.gltf"), options), TYN_ERROR_FILE, "data.bin has 5000 bytes");
}

TEST(BadGltf, DamagedMeshoptDataIsRefused) {
  EXPECT_EQ(tyn_test::load(with_meshopt(nlohmann::json::object())).status, TYN_OK);
  expect_format(with_meshopt({{"byteLength", 3}}), "cannot be decompressed");
  expect_format(with_meshopt({{"byteLength", 100000}}), "covers 100000 bytes");
  expect_format(with_meshopt({{"byteOffset", 1}}), "bufferViews[0].extensions.EXT_meshopt_compression");
  expect_format(with_meshopt({{"byteStride", 0}}), "byteStride is 0");
  expect_format(with_meshopt({{"byteStride", 10}}), "byteStride is 10");
  expect_format(with_meshopt({{"byteStride", 300}}), "byteStride is 300");
  expect_format(with_meshopt({{"count", 1000000000}}), "at most");
  expect_format(with_meshopt({{"count", 2}}), "decompresses to");
  expect_format(with_meshopt({{"mode", "SOMETHING"}}), "mode is \"SOMETHING\"");
  expect_format(with_meshopt({{"mode", "TRIANGLES"}, {"byteStride", 4}, {"count", 4}}), "multiple of 3");
  expect_format(with_meshopt({{"mode", "INDICES"}}), "byteStride is 12");
  expect_format(with_meshopt({{"filter", "OCTAHEDRAL"}}), "the filter OCTAHEDRAL does not allow");
  expect_format(with_meshopt({{"filter", "SEPIA"}}), "filter is \"SEPIA\"");
}

TEST(BadGltf, DamagedImagesAreRefused) {
  expect_format(with_texture("this is not a picture"), "images[0] is neither a PNG nor a JPEG");
  std::string png("\x89PNG\r\n\x1a\n\0\0\0\rIHDR\0\0\0\x02\0\0\0\x02\x08\x06\0\0\0", 29);
  expect_format(with_texture(png + std::string(20, 'x')), "images[0] cannot be decoded");
  png[18] = png[22] = char(0xff); // 65282 x 65282
  expect_format(with_texture(png + std::string(20, 'x')), "images[0] has 65282 x 65282 pixels");
  expect_format(with_texture("\xff\xd8\xff\xe0"), "images[0]");
  Gltf model = with_texture("x");
  model.json["images"][0] = {{"uri", "gone.png"}};
  expect_failure(tyn_test::load(model), TYN_ERROR_FILE, "gone.png: No such file");
  model.json["images"][0] = nlohmann::json::object();
  expect_format(model, "neither a uri nor a bufferView");
}

TEST(BadGltf, UnknownPresetsAndMaterialsAreInvalidArguments) {
  TynMediumAssignment assignment = {nullptr, "unobtainium"};
  TynGltfOptions options = tyn_gltf_options();
  options.assignments = &assignment;
  options.assignment_count = 1;
  expect_failure(tyn_test::load(Gltf::tetrahedron(), options), TYN_ERROR_INVALID_ARGUMENT, "wholemilk");
  assignment = {"no such material", "skin1"};
  expect_failure(tyn_test::load(Gltf::tetrahedron(), options), TYN_ERROR_INVALID_ARGUMENT, "it has stuff");
  assignment = {nullptr, nullptr};
  expect_failure(tyn_test::load(Gltf::tetrahedron(), options), TYN_ERROR_INVALID_ARGUMENT, "NULL");
}

TEST(BadGltf, LightsCamerasAndVolumesThatMakeNoSenseAreRefused) {
  Gltf model = Gltf::tetrahedron();
  model.json["nodes"][0]["camera"] = 0;
  model.json["cameras"] = {{{"type", "fisheye"}}};
  expect_format(model, "cameras[0].type is \"fisheye\"");
  model.json["cameras"] = {{{"type", "perspective"}, {"perspective", {{"yfov", 4}, {"znear", 0.1}}}}};
  expect_format(model, "yfov is 4");
  model = Gltf::tetrahedron();
  model.json["nodes"][0]["extensions"]["KHR_lights_punctual"]["light"] = 0;
  model.json["extensions"]["KHR_lights_punctual"]["lights"] = {{{"type", "neon"}}};
  expect_format(model, "type is \"neon\"");
  model = Gltf::tetrahedron();
  model.material_extension("KHR_materials_transmission") = {{"transmissionFactor", 1}};
  model.material_extension("KHR_materials_volume") = {{"thicknessFactor", 1}, {"attenuationDistance", 0}};
  expect_format(model, "attenuationDistance is 0");
  expect_format(changed("/nodes/0/rotation", {0, 0, 0, 0}), "unit quaternion");
  expect_format(changed("/nodes/0/matrix", {1, 0, 0, 1, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1}), "not affine");
}

TEST(BadGltf, NamesWithLineBreaksStayOnOneLine) {
  expect_format(changed("/nodes", "a\nb\r\x1b[31m"), "nodes is");
  expect_format(changed("/extensionsRequired", {"EVIL\nline"}), "EVIL?line");
}
#endif
