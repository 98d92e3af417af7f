// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
// Members of an extension's object. check_schema() has seen to their types.
#pragma once

#include <string>

#include <tiny_gltf.h>

namespace tyn::io {

inline const tinygltf::Value *member(const tinygltf::Value &object, const char *key) {
  return object.IsObject() && object.Has(key) ? &object.Get(key) : nullptr;
}

inline double number(const tinygltf::Value &object, const char *key, double otherwise) {
  const tinygltf::Value *value = member(object, key);
  return value && value->IsNumber() ? value->GetNumberAsDouble() : otherwise;
}

inline std::string string(const tinygltf::Value &object, const char *key) {
  const tinygltf::Value *value = member(object, key);
  return value && value->IsString() ? value->Get<std::string>() : std::string();
}

// Fills as many numbers as the array has; the others keep what they hold.
template <size_t N>
void numbers(const tinygltf::Value &object, const char *key, double (&result)[N]) {
  const tinygltf::Value *value = member(object, key);
  for (size_t i = 0; value && i < N && i < value->ArrayLen(); i++)
    result[i] = value->Get(int(i)).GetNumberAsDouble();
}

// The extension `name` of a glTF object, or NULL.
inline const tinygltf::Value *extension(const tinygltf::ExtensionMap &extensions, const char *name) {
  const auto found = extensions.find(name);
  return found == extensions.end() ? nullptr : &found->second;
}

} // namespace tyn::io
