// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
// Materials and media: both scatter drafts, volumes, thin walls, presets.
#ifdef TYN_TEST_IO
#include <cmath>

#include <gtest/gtest.h>

#include "common/gltf_builder.hpp"

using tyn_test::Gltf;
using tyn_test::load;
using tyn_test::Loading;

namespace {

// Kulla & Conty 2017 written out in double precision.
double albedo(double color, double g) {
  const double s = 4.09712 + 4.20863 * color - std::sqrt(9.59217 + 41.6808 * color + 17.7126 * color * color);
  return (1 - s * s) / (1 - g * s * s);
}

// A tetrahedron with transmission 1 and a volume: sigma_t = ln 2, ln 4, ln 5 over 0.01 = 69.3, 138.6, 160.9 per metre.
Gltf glass() {
  Gltf model = Gltf::tetrahedron();
  model.material_extension("KHR_materials_transmission") = {{"transmissionFactor", 1}};
  model.material_extension("KHR_materials_volume") = {
      {"thicknessFactor", 1}, {"attenuationDistance", 0.01}, {"attenuationColor", {0.5, 0.25, 0.2}}};
  return model;
}

const double SIGMA_T[3] = {std::log(2.0) / 0.01, std::log(4.0) / 0.01, std::log(5.0) / 0.01};

TynMedium only_medium(const Loading &loading) {
  EXPECT_EQ(loading.status, TYN_OK) << loading.message;
  EXPECT_EQ(loading.scene.media.size(), 1u);
  return loading.scene.media.empty() ? tyn_medium() : loading.scene.media[0].value;
}

TynMaterial first_material(const Loading &loading) {
  EXPECT_EQ(loading.status, TYN_OK) << loading.message;
  EXPECT_FALSE(loading.scene.materials.empty());
  return loading.scene.materials.empty() ? tyn_material() : loading.scene.materials[0].value;
}

void expect_albedo(const TynMedium &medium, const double (&expected)[3]) {
  for (int i = 0; i < 3; i++) {
    EXPECT_NEAR(medium.sigma_a[i] + medium.sigma_s[i], SIGMA_T[i], 1e-5 * SIGMA_T[i]) << i;
    EXPECT_NEAR(medium.sigma_s[i], expected[i] * SIGMA_T[i], 1e-4 * SIGMA_T[i]) << i;
  }
}

void expect_albedo_of_colors(const TynMedium &medium, double r, double g, double b, double anisotropy) {
  expect_albedo(medium, {albedo(r, anisotropy), albedo(g, anisotropy), albedo(b, anisotropy)});
}

// A 1 x 1 PNG of the colour (255, 128, 0, 64).
std::string tiny_png() {
  static const unsigned char BYTES[] = {
      0x89, 0x50, 0x4e, 0x47, 0x0d, 0x0a, 0x1a, 0x0a, 0x00, 0x00, 0x00, 0x0d, 0x49, 0x48, 0x44, 0x52, 0x00, 0x00,
      0x00, 0x01, 0x00, 0x00, 0x00, 0x01, 0x08, 0x06, 0x00, 0x00, 0x00, 0x1f, 0x15, 0xc4, 0x89, 0x00, 0x00, 0x00,
      0x0d, 0x49, 0x44, 0x41, 0x54, 0x78, 0x9c, 0x63, 0xf8, 0xdf, 0xc0, 0xe0, 0x00, 0x00, 0x05, 0xc1, 0x01, 0xc0,
      0x96, 0x0c, 0x82, 0xa6, 0x00, 0x00, 0x00, 0x00, 0x49, 0x45, 0x4e, 0x44, 0xae, 0x42, 0x60, 0x82,
  };
  return std::string(reinterpret_cast<const char *>(BYTES), sizeof BYTES);
}

// Adds an image, a texture and texture coordinates; returns a reference to the texture.
nlohmann::json add_texture(Gltf &model) {
  const int view = model.view_of_bytes(tiny_png());
  model.json["images"] = {{{"bufferView", view}, {"mimeType", "image/png"}, {"name", "picture"}}};
  model.json["textures"] = {{{"source", 0}}};
  model.primitive()["attributes"]["TEXCOORD_0"] = model.floats({0, 0, 1, 0, 0, 1, 1, 1}, "VEC2");
  return {{"index", 0}};
}

} // namespace

TEST(GltfMaterials, FactorsAreTakenOver) {
  Gltf model = Gltf::tetrahedron();
  model.material()["pbrMetallicRoughness"] = {
      {"baseColorFactor", {0.1, 0.2, 0.3, 1}}, {"metallicFactor", 0.25}, {"roughnessFactor", 0.75}};
  model.material()["emissiveFactor"] = {1, 0.5, 0};
  model.material()["doubleSided"] = true;
  model.material_extension("KHR_materials_ior") = {{"ior", 1.33}};
  model.material_extension("KHR_materials_emissive_strength") = {{"emissiveStrength", 8}};
  const TynMaterial material = first_material(load(model));
  EXPECT_FLOAT_EQ(material.base_color[2], 0.3f);
  EXPECT_FLOAT_EQ(material.metallic, 0.25f);
  EXPECT_FLOAT_EQ(material.roughness, 0.75f);
  EXPECT_FLOAT_EQ(material.ior, 1.33f);
  EXPECT_FLOAT_EQ(material.emission[0], 8);
  EXPECT_FLOAT_EQ(material.emission[1], 4);
  EXPECT_EQ(material.double_sided, 1u);
  EXPECT_EQ(material.transmission, 0);
  EXPECT_EQ(material.thin_walled, 0u);
}

TEST(GltfMaterials, DefaultsAreThoseOfGltf) {
  Gltf model = Gltf::tetrahedron();
  model.json["materials"] = {nlohmann::json::object()};
  const TynMaterial material = first_material(load(model));
  EXPECT_EQ(material.base_color[0], 1);
  EXPECT_EQ(material.metallic, 1);
  EXPECT_EQ(material.roughness, 1);
  EXPECT_EQ(material.ior, 1.5f);
  EXPECT_EQ(material.multiscatter_color[0], -1);
}

TEST(GltfMaterials, FactorOutOfRangeIsMovedToTheLimitWithAWarning) {
  Gltf model = Gltf::tetrahedron();
  model.material()["pbrMetallicRoughness"]["roughnessFactor"] = 1.5;
  const Loading loading = load(model);
  EXPECT_EQ(first_material(loading).roughness, 1);
  EXPECT_TRUE(loading.warned("materials[0].pbrMetallicRoughness.roughnessFactor is 1.5"));
}

TEST(GltfMaterials, VolumeWithoutScatteringOnlyAbsorbs) {
  Gltf model = glass();
  model.material_extension("KHR_materials_ior") = {{"ior", 1.4}};
  const Loading loading = load(model);
  const TynMedium medium = only_medium(loading);
  expect_albedo(medium, {0, 0, 0});
  EXPECT_EQ(medium.sigma_s[0], 0);
  EXPECT_FLOAT_EQ(medium.ior, 1.4f);
  EXPECT_EQ(loading.scene.media[0].name, "stuff");
  EXPECT_EQ(loading.scene.meshes[0].medium, 0u);
  EXPECT_EQ(first_material(loading).transmission, 1);
  EXPECT_EQ(first_material(loading).thin_walled, 0u);
  EXPECT_TRUE(loading.warnings.empty());
}

TEST(GltfMaterials, ScatterDraftGivesTheAlbedoOfItsColourTimesItsStrength) {
  Gltf model = glass();
  model.material_extension("KHR_materials_scatter") = {
      {"scatterStrengthFactor", 0.5}, {"multiscatterColorFactor", {1, 0.6, 0.2}}, {"scatterAnisotropy", 0.7}};
  const Loading loading = load(model);
  const TynMedium medium = only_medium(loading);
  expect_albedo_of_colors(medium, 0.5, 0.3, 0.1, 0.7);
  EXPECT_FLOAT_EQ(medium.g, 0.7f);
  EXPECT_EQ(first_material(loading).multiscatter_color[0], -1); // the medium says it all
  EXPECT_TRUE(loading.warnings.empty());
}

TEST(GltfMaterials, ScatterDraftDefaultsToWhiteAndAStrengthOfZeroWithAWarning) {
  Gltf model = glass();
  model.material_extension("KHR_materials_scatter") = nlohmann::json::object();
  const Loading loading = load(model);
  EXPECT_EQ(only_medium(loading).sigma_s[0], 0);
  EXPECT_TRUE(loading.warned("nothing scatters, because scatterStrengthFactor is 0"));
  model.material_extension("KHR_materials_scatter") = {{"scatterStrengthFactor", 1}};
  expect_albedo_of_colors(only_medium(load(model)), 1, 1, 1, 0);
}

TEST(GltfMaterials, OlderDraftIsReadInAllItsSpellings) {
  for (const char *key : {"multiscatterColorFactor", "multiscatterColor", "scatterAlbedo"}) {
    Gltf model = glass();
    model.material_extension("KHR_materials_volume_scatter") = {{key, {0.9, 0.5, 0.1}}, {"scatterAnisotropy", -0.3}};
    const Loading loading = load(model);
    expect_albedo_of_colors(only_medium(loading), 0.9, 0.5, 0.1, -0.3);
    EXPECT_TRUE(loading.warnings.empty()) << key;
  }
}

TEST(GltfMaterials, OlderDraftDefaultsToBlackWithAWarning) {
  Gltf model = glass();
  model.material_extension("KHR_materials_volume_scatter") = {{"scatterAnisotropy", 0.5}};
  const Loading loading = load(model);
  EXPECT_EQ(only_medium(loading).sigma_s[1], 0);
  EXPECT_TRUE(loading.warned("multiscatterColorFactor is black"));
}

TEST(GltfMaterials, NewerDraftAndNewerSpellingArePreferred) {
  Gltf model = glass();
  model.material_extension("KHR_materials_volume_scatter") = {{"multiscatterColorFactor", {0.1, 0.1, 0.1}}};
  model.material_extension("KHR_materials_scatter") = {{"scatterStrengthFactor", 1},
                                                       {"multiscatterColorFactor", {0.8, 0.8, 0.8}},
                                                       {"multiscatterColor", {0.2, 0.2, 0.2}}};
  expect_albedo_of_colors(only_medium(load(model)), 0.8, 0.8, 0.8, 0);
}

TEST(GltfMaterials, ScatteringWithoutTransmissionLetsLightInWithAWarning) {
  Gltf model = glass();
  model.material()["extensions"].erase("KHR_materials_transmission");
  EXPECT_TRUE(load(model).scene.media.empty()); // a volume alone is behind an opaque surface
  model.material_extension("KHR_materials_volume_scatter") = {{"multiscatterColor", {0.9, 0.5, 0.1}}};
  const Loading loading = load(model);
  only_medium(loading);
  EXPECT_EQ(first_material(loading).transmission, 1);
  EXPECT_TRUE(loading.warned("without KHR_materials_transmission"));
  model.material_extension("KHR_materials_diffuse_transmission") = {{"diffuseTransmissionFactor", 0.75}};
  EXPECT_FLOAT_EQ(first_material(load(model)).transmission, 0.75f);
}

TEST(GltfMaterials, NodeScaleDoesNotScaleTheAttenuationDistance) {
  Gltf model = glass();
  model.json["nodes"][0]["scale"] = {100, 100, 100};
  expect_albedo(only_medium(load(model)), {0, 0, 0});
}

TEST(GltfMaterials, WhiteAttenuationIsAnEmptyMediumAndBlackIsClamped) {
  Gltf model = glass();
  model.material_extension("KHR_materials_volume") = {{"thicknessFactor", 1}};
  model.material_extension("KHR_materials_scatter") = {{"scatterStrengthFactor", 1}};
  Loading loading = load(model);
  EXPECT_EQ(only_medium(loading).sigma_s[0], 0);
  EXPECT_EQ(only_medium(loading).sigma_a[0], 0);
  EXPECT_TRUE(loading.warned("attenuationColor is white"));
  model.material_extension("KHR_materials_volume") = {
      {"thicknessFactor", 1}, {"attenuationDistance", 2}, {"attenuationColor", {1, 0, 0.5}}};
  model.material()["extensions"].erase("KHR_materials_scatter");
  loading = load(model);
  EXPECT_NEAR(only_medium(loading).sigma_a[1], -std::log(1e-6) / 2, 1e-4);
  EXPECT_EQ(only_medium(loading).sigma_a[0], 0);
  EXPECT_TRUE(loading.warned("black channel"));
}

TEST(GltfMaterials, HugeAttenuationDistanceWrittenAsAnIntegerIsNotTruncated) {
  Gltf model = glass();
  model.material_extension("KHR_materials_volume")["attenuationDistance"] = 100000000000;
  EXPECT_NEAR(only_medium(load(model)).sigma_a[0] * 1e11, std::log(2.0), 1e-5);
}

TEST(GltfMaterials, TransmissionWithoutThicknessIsThinWalled) {
  Gltf model = glass();
  model.material_extension("KHR_materials_volume")["thicknessFactor"] = 0;
  const Loading loading = load(model);
  EXPECT_TRUE(loading.scene.media.empty());
  EXPECT_EQ(first_material(loading).thin_walled, 1u);
  EXPECT_EQ(first_material(loading).thin_scatter, 0);
  EXPECT_EQ(loading.scene.meshes[0].medium, TYN_NONE);
}

TEST(GltfMaterials, ScatteringWithoutThicknessIsAThinWallThatScatters) {
  Gltf model = Gltf::tetrahedron();
  model.material_extension("KHR_materials_transmission") = {{"transmissionFactor", 0.9}};
  model.material_extension("KHR_materials_scatter") = {
      {"scatterStrengthFactor", 0.5}, {"multiscatterColorFactor", {0.3, 0.6, 0.9}}, {"scatterAnisotropy", 0.25}};
  const Loading loading = load(model);
  const TynMaterial material = first_material(loading);
  EXPECT_EQ(material.thin_walled, 1u);
  EXPECT_FLOAT_EQ(material.transmission, 0.9f);
  EXPECT_FLOAT_EQ(material.thin_scatter, 0.5f);
  EXPECT_FLOAT_EQ(material.thin_scatter_color[2], 0.9f);
  EXPECT_FLOAT_EQ(material.thin_scatter_anisotropy, 0.25f);
  EXPECT_TRUE(loading.warned("thin-walled"));
}

TEST(GltfMaterials, DiffuseTransmissionIsAThinWallThatScattersForward) {
  Gltf model = Gltf::tetrahedron();
  model.material_extension("KHR_materials_diffuse_transmission") = {
      {"diffuseTransmissionFactor", 0.4}, {"diffuseTransmissionColorFactor", {0.1, 0.2, 0.3}}};
  const TynMaterial material = first_material(load(model));
  EXPECT_EQ(material.thin_walled, 1u);
  EXPECT_FLOAT_EQ(material.transmission, 0.4f);
  EXPECT_EQ(material.thin_scatter, 1);
  EXPECT_EQ(material.thin_scatter_anisotropy, 1);
  EXPECT_FLOAT_EQ(material.thin_scatter_color[1], 0.2f);
}

TEST(GltfMaterials, ColourTextureDrivesTheScatteringFromTheEntryPoint) {
  Gltf model = glass();
  const nlohmann::json texture = add_texture(model);
  model.material_extension("KHR_materials_scatter") = {{"scatterStrengthFactor", 0.5},
                                                       {"multiscatterColorFactor", {0.8, 0.6, 0.4}},
                                                       {"multiscatterColorTexture", texture},
                                                       {"scatterStrengthTexture", texture}};
  const Loading loading = load(model);
  const TynMaterial material = first_material(loading);
  EXPECT_FLOAT_EQ(material.multiscatter_color[0], 0.8f);
  EXPECT_FLOAT_EQ(material.scatter_strength, 0.5f);
  expect_albedo_of_colors(only_medium(loading), 0.4, 0.3, 0.2, 0);
  // One image of the file, once with the sRGB curve for the colour and once without for the strength.
  ASSERT_EQ(loading.scene.images.size(), 2u);
  EXPECT_EQ(loading.scene.images[material.multiscatter_color_texture.image].format, uint32_t(TYN_IMAGE_RGBA8_SRGB));
  EXPECT_EQ(loading.scene.images[material.scatter_strength_texture.image].format, uint32_t(TYN_IMAGE_RGBA8_LINEAR));
  EXPECT_EQ(loading.scene.images[0].name, "picture");
  EXPECT_EQ(loading.scene.images[0].pixels, tyn::io::Bytes({255, 128, 0, 64}));
}

TEST(GltfMaterials, SamplerAndTextureTransformAreTakenOver) {
  Gltf model = Gltf::tetrahedron();
  nlohmann::json texture = add_texture(model);
  model.json["samplers"] = {{{"magFilter", 9728}, {"wrapS", 33071}, {"wrapT", 33648}}};
  model.json["textures"][0]["sampler"] = 0;
  texture["extensions"]["KHR_texture_transform"] = {
      {"offset", {0, 1}}, {"rotation", std::acos(-1.0) / 2}, {"scale", {0.5, 0.25}}};
  model.material()["pbrMetallicRoughness"]["baseColorTexture"] = texture;
  const TynTexture result = first_material(load(model)).base_color_texture;
  EXPECT_EQ(result.wrap_u, uint32_t(TYN_WRAP_CLAMP));
  EXPECT_EQ(result.wrap_v, uint32_t(TYN_WRAP_MIRROR));
  EXPECT_EQ(result.filter, uint32_t(TYN_FILTER_NEAREST));
  // The extension's own example: a quarter turn that shows the lower left part of the image.
  const float expected[6] = {0, 0.25f, 0, -0.5f, 0, 1};
  for (int i = 0; i < 6; i++)
    EXPECT_NEAR(result.transform[i], expected[i], 1e-6) << i;
}

TEST(GltfMaterials, ASecondSetOfTextureCoordinatesIsUsedIfTheFirstTextureSaysSo) {
  Gltf model = Gltf::tetrahedron();
  nlohmann::json texture = add_texture(model);
  model.primitive()["attributes"]["TEXCOORD_1"] = model.floats({9, 9, 8, 8, 7, 7, 6, 6}, "VEC2");
  texture["texCoord"] = 1;
  model.material()["pbrMetallicRoughness"]["baseColorTexture"] = texture;
  texture["texCoord"] = 0;
  model.material()["normalTexture"] = texture;
  const Loading loading = load(model);
  EXPECT_EQ(loading.scene.meshes[0].uvs[0], 9);
  EXPECT_EQ(first_material(loading).normal_texture.image, TYN_NONE);
  EXPECT_TRUE(loading.warned("normalTexture uses TEXCOORD_0"));
}

TEST(GltfMaterials, ImagesComeFromDataUrisAndFilesToo) {
  Gltf model = Gltf::tetrahedron();
  model.material()["pbrMetallicRoughness"]["baseColorTexture"] = add_texture(model);
  model.json["images"] = {{{"uri", "data:image/png;base64," + tyn_test::base64(tiny_png())}}};
  EXPECT_EQ(load(model).scene.images.size(), 1u);
  model.json["images"] = {{{"uri", "maps/color.png"}}};
  const tyn_test::TemporaryFolder folder;
  ASSERT_EQ(std::system(("mkdir " + folder.file("maps")).c_str()), 0);
  folder.write("maps/color.png", tiny_png());
  folder.write("model.gltf", model.ascii());
  const Loading loading = tyn_test::load_file(folder.file("model.gltf"));
  ASSERT_EQ(loading.status, TYN_OK) << loading.message;
  EXPECT_EQ(loading.scene.images[0].width, 1u);
}

TEST(GltfMaterials, UnusedImageIsNotEvenOpened) {
  Gltf model = Gltf::tetrahedron();
  model.json["images"] = {{{"uri", "missing.png"}}};
  model.json["textures"] = {{{"source", 0}}};
  EXPECT_EQ(load(model).status, TYN_OK);
}

TEST(GltfMaterials, AlphaAndUnlitAreWarnedAbout) {
  Gltf model = Gltf::tetrahedron();
  model.material()["alphaMode"] = "BLEND";
  model.material_extension("KHR_materials_unlit") = nlohmann::json::object();
  const Loading loading = load(model);
  EXPECT_TRUE(loading.warned("alphaMode is BLEND"));
  EXPECT_TRUE(loading.warned("KHR_materials_unlit"));
}

namespace {

Loading load_with_preset(const Gltf &model, const char *material, const char *medium) {
  const TynMediumAssignment assignment = {material, medium};
  TynGltfOptions options = tyn_gltf_options();
  options.assignments = &assignment;
  options.assignment_count = 1;
  return load(model, options);
}

} // namespace

TEST(GltfMaterials, AssignedPresetTurnsADielectricIntoAMedium) {
  for (const char *material : {(const char *)nullptr, "ALL", "stuff"}) {
    const Loading loading = load_with_preset(Gltf::tetrahedron(), material, "marble");
    const TynMedium medium = only_medium(loading);
    // Jensen 2001 in 1/mm, in a scene in metres.
    EXPECT_NEAR(medium.sigma_s[0], 2190, 1e-2);
    EXPECT_NEAR(medium.sigma_a[2], 7.1, 1e-4);
    EXPECT_FLOAT_EQ(medium.ior, 1.5f);
    EXPECT_EQ(loading.scene.media[0].name, "marble");
    const TynMaterial surface = first_material(loading);
    EXPECT_EQ(surface.transmission, 1);
    EXPECT_EQ(surface.multiscatter_color[0], -1); // a white material keeps the preset's own albedo
    EXPECT_EQ(loading.scene.meshes[0].medium, 0u);
  }
}

TEST(GltfMaterials, BaseColourDrivesAnAssignedPreset) {
  Gltf model = Gltf::tetrahedron();
  model.material()["pbrMetallicRoughness"]["baseColorFactor"] = {0.5, 0.25, 1, 1};
  TynMaterial material = first_material(load_with_preset(model, nullptr, "skin1"));
  EXPECT_FLOAT_EQ(material.multiscatter_color[1], 0.25f);
  EXPECT_EQ(material.multiscatter_color_texture.image, TYN_NONE);
  EXPECT_FLOAT_EQ(material.ior, 1.3f);
  model.material()["pbrMetallicRoughness"]["baseColorTexture"] = add_texture(model);
  material = first_material(load_with_preset(model, nullptr, "skin1"));
  EXPECT_EQ(material.multiscatter_color_texture.image, material.base_color_texture.image);
  EXPECT_NE(material.multiscatter_color_texture.image, TYN_NONE);
}

TEST(GltfMaterials, AllLeavesMetalsAloneAndANameDoesNot) {
  Gltf model = Gltf::tetrahedron();
  model.material()["pbrMetallicRoughness"]["metallicFactor"] = 1;
  EXPECT_TRUE(load_with_preset(model, "ALL", "skin1").scene.media.empty());
  const Loading named = load_with_preset(model, "stuff", "skin1");
  EXPECT_EQ(first_material(named).metallic, 0);
  EXPECT_TRUE(named.warned("metallic"));
  model.primitive().erase("material"); // no material at all is nobody's wish for metal
  EXPECT_EQ(load_with_preset(model, "ALL", "skin1").scene.media.size(), 1u);
}

TEST(GltfMaterials, LastMatchingAssignmentWins) {
  const TynMediumAssignment assignments[] = {{"stuff", "marble"}, {nullptr, "cream"}};
  TynGltfOptions options = tyn_gltf_options();
  options.assignments = assignments;
  options.assignment_count = 2;
  EXPECT_EQ(load(Gltf::tetrahedron(), options).scene.media[0].name, "cream");
}

TEST(GltfMaterials, AssignedPresetReplacesWhatTheFileSaysAboutTheVolume) {
  Gltf model = glass();
  model.material_extension("KHR_materials_scatter") = {{"scatterStrengthFactor", 1}};
  EXPECT_NEAR(only_medium(load_with_preset(model, nullptr, "wholemilk")).sigma_s[0], 2550, 1e-2);
}

TEST(GltfMaterials, MaterialsWithEqualMediaShareOneAndTheirPrimitivesOneMesh) {
  Gltf model = Gltf::tetrahedron();
  model.json["materials"].push_back(
      {{"name", "red"}, {"pbrMetallicRoughness", {{"metallicFactor", 0}, {"baseColorFactor", {1, 0, 0, 1}}}}});
  nlohmann::json second = model.primitive();
  second["material"] = 1;
  model.json["meshes"][0]["primitives"].push_back(second);
  const Loading loading = load_with_preset(model, nullptr, "skin1");
  EXPECT_EQ(loading.scene.media.size(), 1u);
  EXPECT_EQ(loading.scene.meshes.size(), 1u);
  EXPECT_EQ(load_with_preset(model, "red", "skin1").scene.meshes.size(), 2u);
}
#endif
