// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
// The part of the glTF 2.0 schema that the loader relies on, as a table.
#include <cinttypes>
#include <climits>
#include <cmath>
#include <string>

#include "io/failure.hpp"
#include "io/gltf_json.hpp"

namespace tyn::io {
namespace {

enum class Kind {
  Object,
  Array,
  String, // one of those in `list`, which | separates, if there is one
  Boolean,
  Number,   // finite
  Unsigned, // an integer in [0, limit]
  Index,    // an integer below the number of elements of the top-level array `list`
  Numbers   // an array of `limit` finite numbers (0: any number of them)
};

struct Rule {
  const char *path; // [] every element of an array, * every member of an object, ! a required property
  Kind kind;
  uint64_t limit;
  const char *list;
};

constexpr uint64_t ANY = (uint64_t)1 << 53; // what a double still counts exactly

// A texture reference and what KHR_texture_transform may say about it.
#define TEXTURE(path)                                                                                                  \
  {path, Kind::Object, 0, nullptr}, {path ".index!", Kind::Index, 0, "textures"},                                      \
      {path ".texCoord", Kind::Unsigned, INT_MAX, nullptr}, {path ".extensions", Kind::Object, 0, nullptr},            \
      {path ".extensions.KHR_texture_transform", Kind::Object, 0, nullptr},                                            \
      {path ".extensions.KHR_texture_transform.offset", Kind::Numbers, 2, nullptr},                                    \
      {path ".extensions.KHR_texture_transform.scale", Kind::Numbers, 2, nullptr},                                     \
      {path ".extensions.KHR_texture_transform.rotation", Kind::Number, 0, nullptr}, {                                 \
    path ".extensions.KHR_texture_transform.texCoord", Kind::Unsigned, INT_MAX, nullptr                                \
  }

#define MESHOPT(path)                                                                                                  \
  {path, Kind::Object, 0, nullptr}, {path ".buffer!", Kind::Index, 0, "buffers"},                                      \
      {path ".byteOffset", Kind::Unsigned, ANY, nullptr}, {path ".byteLength!", Kind::Unsigned, ANY, nullptr},         \
      {path ".byteStride!", Kind::Unsigned, 256, nullptr}, {path ".count!", Kind::Unsigned, INT_MAX, nullptr},         \
      {path ".mode!", Kind::String, 0, "ATTRIBUTES|TRIANGLES|INDICES"}, {                                              \
    path ".filter", Kind::String, 0, "NONE|OCTAHEDRAL|QUATERNION|EXPONENTIAL"                                          \
  }

#define MATERIAL(extension) "materials[].extensions." extension

// A parent comes before its children, and a list before the indices into it.
const Rule RULES[] = {
    {"scenes", Kind::Array, 0, nullptr},
    {"nodes", Kind::Array, 0, nullptr},
    {"meshes", Kind::Array, 0, nullptr},
    {"accessors", Kind::Array, 0, nullptr},
    {"bufferViews", Kind::Array, 0, nullptr},
    {"buffers", Kind::Array, 0, nullptr},
    {"skins", Kind::Array, 0, nullptr},
    {"images", Kind::Array, 0, nullptr},
    {"samplers", Kind::Array, 0, nullptr},
    {"textures", Kind::Array, 0, nullptr},
    {"cameras", Kind::Array, 0, nullptr},
    {"materials", Kind::Array, 0, nullptr},
    {"extensionsUsed", Kind::Array, 0, nullptr},
    {"extensionsRequired", Kind::Array, 0, nullptr},
    {"extensions", Kind::Object, 0, nullptr},
    {"extensions.KHR_lights_punctual", Kind::Object, 0, nullptr},
    {"extensions.KHR_lights_punctual.lights!", Kind::Array, 0, nullptr},
    {"scene", Kind::Index, 0, "scenes"},
    {"scenes[]", Kind::Object, 0, nullptr},
    {"scenes[].nodes", Kind::Array, 0, nullptr},
    {"scenes[].nodes[]", Kind::Index, 0, "nodes"},

    {"nodes[]", Kind::Object, 0, nullptr},
    {"nodes[].name", Kind::String, 0, nullptr},
    {"nodes[].children", Kind::Array, 0, nullptr},
    {"nodes[].children[]", Kind::Index, 0, "nodes"},
    {"nodes[].mesh", Kind::Index, 0, "meshes"},
    {"nodes[].camera", Kind::Index, 0, "cameras"},
    {"nodes[].skin", Kind::Index, 0, "skins"},
    {"nodes[].matrix", Kind::Numbers, 16, nullptr},
    {"nodes[].translation", Kind::Numbers, 3, nullptr},
    {"nodes[].rotation", Kind::Numbers, 4, nullptr},
    {"nodes[].scale", Kind::Numbers, 3, nullptr},
    {"nodes[].weights", Kind::Numbers, 0, nullptr},
    {"nodes[].extensions", Kind::Object, 0, nullptr},
    {"nodes[].extensions.KHR_lights_punctual", Kind::Object, 0, nullptr},
    {"nodes[].extensions.KHR_lights_punctual.light!", Kind::Index, 0, "extensions.KHR_lights_punctual.lights"},

    {"meshes[]", Kind::Object, 0, nullptr},
    {"meshes[].name", Kind::String, 0, nullptr},
    {"meshes[].weights", Kind::Numbers, 0, nullptr},
    {"meshes[].primitives!", Kind::Array, 0, nullptr},
    {"meshes[].primitives[]", Kind::Object, 0, nullptr},
    {"meshes[].primitives[].attributes!", Kind::Object, 0, nullptr},
    {"meshes[].primitives[].attributes.*", Kind::Index, 0, "accessors"},
    {"meshes[].primitives[].indices", Kind::Index, 0, "accessors"},
    {"meshes[].primitives[].material", Kind::Index, 0, "materials"},
    {"meshes[].primitives[].mode", Kind::Unsigned, 6, nullptr},
    {"meshes[].primitives[].targets", Kind::Array, 0, nullptr},
    {"meshes[].primitives[].targets[]", Kind::Object, 0, nullptr},
    {"meshes[].primitives[].extensions", Kind::Object, 0, nullptr},

    {"accessors[]", Kind::Object, 0, nullptr},
    {"accessors[].bufferView", Kind::Index, 0, "bufferViews"},
    {"accessors[].byteOffset", Kind::Unsigned, ANY, nullptr},
    {"accessors[].componentType!", Kind::Unsigned, INT_MAX, nullptr},
    {"accessors[].normalized", Kind::Boolean, 0, nullptr},
    {"accessors[].count!", Kind::Unsigned, UINT32_MAX, nullptr},
    {"accessors[].type!", Kind::String, 0, "SCALAR|VEC2|VEC3|VEC4|MAT2|MAT3|MAT4"},
    {"accessors[].min", Kind::Numbers, 0, nullptr},
    {"accessors[].max", Kind::Numbers, 0, nullptr},
    {"accessors[].sparse", Kind::Object, 0, nullptr},
    {"accessors[].sparse.count!", Kind::Unsigned, INT_MAX, nullptr},
    {"accessors[].sparse.indices!", Kind::Object, 0, nullptr},
    {"accessors[].sparse.indices.bufferView!", Kind::Index, 0, "bufferViews"},
    {"accessors[].sparse.indices.byteOffset", Kind::Unsigned, INT_MAX, nullptr},
    {"accessors[].sparse.indices.componentType!", Kind::Unsigned, INT_MAX, nullptr},
    {"accessors[].sparse.values!", Kind::Object, 0, nullptr},
    {"accessors[].sparse.values.bufferView!", Kind::Index, 0, "bufferViews"},
    {"accessors[].sparse.values.byteOffset", Kind::Unsigned, INT_MAX, nullptr},

    {"bufferViews[]", Kind::Object, 0, nullptr},
    {"bufferViews[].buffer!", Kind::Index, 0, "buffers"},
    {"bufferViews[].byteOffset", Kind::Unsigned, ANY, nullptr},
    {"bufferViews[].byteLength!", Kind::Unsigned, ANY, nullptr},
    {"bufferViews[].byteStride", Kind::Unsigned, 252, nullptr},
    {"bufferViews[].extensions", Kind::Object, 0, nullptr},
    MESHOPT("bufferViews[].extensions.EXT_meshopt_compression"),
    MESHOPT("bufferViews[].extensions.KHR_meshopt_compression"),

    {"buffers[]", Kind::Object, 0, nullptr},
    {"buffers[].byteLength!", Kind::Unsigned, ANY, nullptr},
    {"buffers[].uri", Kind::String, 0, nullptr},
    {"buffers[].extensions", Kind::Object, 0, nullptr},

    {"images[]", Kind::Object, 0, nullptr},
    {"images[].name", Kind::String, 0, nullptr},
    {"images[].uri", Kind::String, 0, nullptr},
    {"images[].bufferView", Kind::Index, 0, "bufferViews"},
    {"samplers[]", Kind::Object, 0, nullptr},
    {"samplers[].magFilter", Kind::Unsigned, INT_MAX, nullptr},
    {"samplers[].minFilter", Kind::Unsigned, INT_MAX, nullptr},
    {"samplers[].wrapS", Kind::Unsigned, INT_MAX, nullptr},
    {"samplers[].wrapT", Kind::Unsigned, INT_MAX, nullptr},
    {"textures[]", Kind::Object, 0, nullptr},
    {"textures[].source", Kind::Index, 0, "images"},
    {"textures[].sampler", Kind::Index, 0, "samplers"},

    {"cameras[]", Kind::Object, 0, nullptr},
    {"cameras[].name", Kind::String, 0, nullptr},
    {"cameras[].type!", Kind::String, 0, "perspective|orthographic"},
    {"cameras[].perspective", Kind::Object, 0, nullptr},
    {"cameras[].perspective.yfov!", Kind::Number, 0, nullptr},
    {"cameras[].perspective.znear!", Kind::Number, 0, nullptr},
    {"cameras[].perspective.aspectRatio", Kind::Number, 0, nullptr},
    {"cameras[].perspective.zfar", Kind::Number, 0, nullptr},
    {"cameras[].orthographic", Kind::Object, 0, nullptr},
    {"cameras[].orthographic.xmag!", Kind::Number, 0, nullptr},
    {"cameras[].orthographic.ymag!", Kind::Number, 0, nullptr},
    {"cameras[].orthographic.znear!", Kind::Number, 0, nullptr},
    {"cameras[].orthographic.zfar!", Kind::Number, 0, nullptr},

    {"extensions.KHR_lights_punctual.lights[]", Kind::Object, 0, nullptr},
    {"extensions.KHR_lights_punctual.lights[].name", Kind::String, 0, nullptr},
    {"extensions.KHR_lights_punctual.lights[].type!", Kind::String, 0, "point|spot|directional"},
    {"extensions.KHR_lights_punctual.lights[].color", Kind::Numbers, 3, nullptr},
    {"extensions.KHR_lights_punctual.lights[].intensity", Kind::Number, 0, nullptr},
    {"extensions.KHR_lights_punctual.lights[].range", Kind::Number, 0, nullptr},
    {"extensions.KHR_lights_punctual.lights[].spot", Kind::Object, 0, nullptr},
    {"extensions.KHR_lights_punctual.lights[].spot.innerConeAngle", Kind::Number, 0, nullptr},
    {"extensions.KHR_lights_punctual.lights[].spot.outerConeAngle", Kind::Number, 0, nullptr},

    {"materials[]", Kind::Object, 0, nullptr},
    {"materials[].name", Kind::String, 0, nullptr},
    {"materials[].doubleSided", Kind::Boolean, 0, nullptr},
    {"materials[].alphaMode", Kind::String, 0, "OPAQUE|MASK|BLEND"},
    {"materials[].alphaCutoff", Kind::Number, 0, nullptr},
    {"materials[].emissiveFactor", Kind::Numbers, 3, nullptr},
    TEXTURE("materials[].emissiveTexture"),
    TEXTURE("materials[].normalTexture"),
    {"materials[].normalTexture.scale", Kind::Number, 0, nullptr},
    TEXTURE("materials[].occlusionTexture"),
    {"materials[].occlusionTexture.strength", Kind::Number, 0, nullptr},
    {"materials[].pbrMetallicRoughness", Kind::Object, 0, nullptr},
    {"materials[].pbrMetallicRoughness.baseColorFactor", Kind::Numbers, 4, nullptr},
    {"materials[].pbrMetallicRoughness.metallicFactor", Kind::Number, 0, nullptr},
    {"materials[].pbrMetallicRoughness.roughnessFactor", Kind::Number, 0, nullptr},
    TEXTURE("materials[].pbrMetallicRoughness.baseColorTexture"),
    TEXTURE("materials[].pbrMetallicRoughness.metallicRoughnessTexture"),
    {"materials[].extensions", Kind::Object, 0, nullptr},

    {MATERIAL("KHR_materials_unlit"), Kind::Object, 0, nullptr},
    {MATERIAL("KHR_materials_ior"), Kind::Object, 0, nullptr},
    {MATERIAL("KHR_materials_ior.ior"), Kind::Number, 0, nullptr},
    {MATERIAL("KHR_materials_emissive_strength"), Kind::Object, 0, nullptr},
    {MATERIAL("KHR_materials_emissive_strength.emissiveStrength"), Kind::Number, 0, nullptr},
    {MATERIAL("KHR_materials_transmission"), Kind::Object, 0, nullptr},
    {MATERIAL("KHR_materials_transmission.transmissionFactor"), Kind::Number, 0, nullptr},
    TEXTURE(MATERIAL("KHR_materials_transmission.transmissionTexture")),
    {MATERIAL("KHR_materials_volume"), Kind::Object, 0, nullptr},
    {MATERIAL("KHR_materials_volume.thicknessFactor"), Kind::Number, 0, nullptr},
    TEXTURE(MATERIAL("KHR_materials_volume.thicknessTexture")),
    {MATERIAL("KHR_materials_volume.attenuationDistance"), Kind::Number, 0, nullptr},
    {MATERIAL("KHR_materials_volume.attenuationColor"), Kind::Numbers, 3, nullptr},
    {MATERIAL("KHR_materials_diffuse_transmission"), Kind::Object, 0, nullptr},
    {MATERIAL("KHR_materials_diffuse_transmission.diffuseTransmissionFactor"), Kind::Number, 0, nullptr},
    TEXTURE(MATERIAL("KHR_materials_diffuse_transmission.diffuseTransmissionTexture")),
    {MATERIAL("KHR_materials_diffuse_transmission.diffuseTransmissionColorFactor"), Kind::Numbers, 3, nullptr},
    TEXTURE(MATERIAL("KHR_materials_diffuse_transmission.diffuseTransmissionColorTexture")),
    {MATERIAL("KHR_materials_scatter"), Kind::Object, 0, nullptr},
    {MATERIAL("KHR_materials_scatter.scatterStrengthFactor"), Kind::Number, 0, nullptr},
    TEXTURE(MATERIAL("KHR_materials_scatter.scatterStrengthTexture")),
    {MATERIAL("KHR_materials_scatter.multiscatterColorFactor"), Kind::Numbers, 3, nullptr},
    {MATERIAL("KHR_materials_scatter.multiscatterColor"), Kind::Numbers, 3, nullptr},
    TEXTURE(MATERIAL("KHR_materials_scatter.multiscatterColorTexture")),
    {MATERIAL("KHR_materials_scatter.scatterAnisotropy"), Kind::Number, 0, nullptr},
    {MATERIAL("KHR_materials_volume_scatter"), Kind::Object, 0, nullptr},
    {MATERIAL("KHR_materials_volume_scatter.multiscatterColorFactor"), Kind::Numbers, 3, nullptr},
    {MATERIAL("KHR_materials_volume_scatter.multiscatterColor"), Kind::Numbers, 3, nullptr},
    {MATERIAL("KHR_materials_volume_scatter.scatterAlbedo"), Kind::Numbers, 3, nullptr},
    TEXTURE(MATERIAL("KHR_materials_volume_scatter.multiscatterColorTexture")),
    {MATERIAL("KHR_materials_volume_scatter.scatterAnisotropy"), Kind::Number, 0, nullptr},
};

class Checker {
public:
  explicit Checker(Json &json) : root(json) {}

  void check(const Rule &rule) {
    where.clear();
    descend(root, rule.path, rule);
  }

private:
  void descend(Json &value, const char *path, const Rule &rule);
  void descend_array(Json &array, const char *path, const Rule &rule);
  void check_value(Json &value, const Rule &rule);
  void check_string(const Json &value, const Rule &rule) const;
  uint64_t integer(Json &value) const;
  void check_numbers(const Json &value, const Rule &rule) const;
  size_t length_of(const char *list) const;

  [[noreturn]] void refuse(const Json &value, const std::string &allowed) const {
    const std::string dump = value.is_object()  ? "an object"
                             : value.is_array() ? "an array"
                                                : value.dump(-1, ' ', true);
    fail(TYN_ERROR_FORMAT, "%s is %s; it must be %s", printable(where).c_str(), printable(dump).c_str(),
         allowed.c_str());
  }

  Json &root;
  std::string where; // the JSON path of what is looked at
};

// Follows the rest of a rule's path from `value` to every element it names.
void Checker::descend(Json &value, const char *path, const Rule &rule) {
  if (*path == '\0')
    return check_value(value, rule);
  if (*path == '[')
    return descend_array(value, path + 2, rule);
  if (*path == '.')
    path++;
  if (!value.is_object()) // a value that its own rule has already refused cannot be here
    return;
  const size_t length = std::strcspn(path, ".[!");
  std::string key(path, length);
  path += length;
  const bool required = *path == '!';
  path += required;
  const size_t before = where.size();
  for (auto member = value.begin(); member != value.end(); ++member) {
    if (key != "*" && member.key() != key)
      continue;
    where += (before ? "." : "") + member.key();
    descend(member.value(), path, rule);
    where.resize(before);
  }
  if (required && value.find(key) == value.end())
    fail(TYN_ERROR_FORMAT, "%s.%s is missing", printable(where).c_str(), key.c_str());
}

void Checker::descend_array(Json &array, const char *path, const Rule &rule) {
  if (!array.is_array())
    return;
  const size_t before = where.size();
  for (size_t i = 0; i < array.size(); i++) {
    where += "[" + std::to_string(i) + "]";
    descend(array[i], path, rule);
    where.resize(before);
  }
}

void Checker::check_value(Json &value, const Rule &rule) {
  switch (rule.kind) {
  case Kind::Object:
    return value.is_object() ? void() : refuse(value, "an object");
  case Kind::Array:
    return value.is_array() ? void() : refuse(value, "an array");
  case Kind::String:
    return check_string(value, rule);
  case Kind::Boolean:
    return value.is_boolean() ? void() : refuse(value, "true or false");
  case Kind::Number:
    return value.is_number() ? void() : refuse(value, "a number");
  case Kind::Unsigned:
    if (integer(value) > rule.limit)
      refuse(value, text("at most %" PRIu64, rule.limit));
    return;
  case Kind::Index: {
    const size_t length = length_of(rule.list);
    if (integer(value) >= length)
      refuse(value, text("an index into %s, which has %zu elements", rule.list, length));
    return;
  }
  case Kind::Numbers:
    return check_numbers(value, rule);
  }
}

void Checker::check_string(const Json &value, const Rule &rule) const {
  if (!value.is_string())
    refuse(value, "a string");
  if (!rule.list)
    return;
  const std::string choices = "|" + std::string(rule.list) + "|", given = value.get<std::string>();
  if (given.find('|') != std::string::npos || choices.find("|" + given + "|") == std::string::npos)
    refuse(value, "one of " + std::string(rule.list));
}

// The value of an integer; 3.0 counts as one and is rewritten.
uint64_t Checker::integer(Json &value) const {
  if (value.is_number_float()) {
    const double number = value.get<double>();
    if (number >= 0 && number < double(ANY) && number == std::floor(number))
      value = uint64_t(number);
  }
  if (!value.is_number_unsigned())
    refuse(value, "an integer that is not negative");
  return value.get<uint64_t>();
}

void Checker::check_numbers(const Json &value, const Rule &rule) const {
  if (!value.is_array() || (rule.limit && value.size() != rule.limit))
    refuse(value, rule.limit ? text("an array of %" PRIu64 " numbers", rule.limit) : "an array of numbers");
  for (const Json &number : value)
    if (!number.is_number())
      refuse(value, "an array of numbers");
}

size_t Checker::length_of(const char *list) const {
  const Json *value = &root;
  for (const char *key = list; *key;) {
    const size_t length = std::strcspn(key, ".");
    const auto member = value->find(std::string(key, length));
    if (!value->is_object() || member == value->end())
      return 0;
    value = &*member;
    key += length + (key[length] == '.');
  }
  return value->is_array() ? value->size() : 0;
}

} // namespace

void check_schema(Json &root) {
  Checker checker(root);
  for (const Rule &rule : RULES)
    checker.check(rule);
}

} // namespace tyn::io
