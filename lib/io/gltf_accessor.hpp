// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
// The contents of accessors: every layout that glTF allows, turned into floats or indices, every read checked.
#pragma once

#include <string>
#include <vector>

#include "io/gltf_document.hpp"

namespace tyn::io {

// Whether `count` elements of `size` bytes, `stride` apart, the first at `offset`, lie within `available` bytes. No sum or
// product in it can overflow unnoticed.
bool elements_fit(uint64_t offset, uint64_t stride, uint64_t count, uint64_t size, uint64_t available);

class GltfAccessors {
public:
  GltfAccessors(GltfDocument &source, uint64_t limit) : document(source), max_elements(limit) {}

  // The elements of accessor `index`, `components` floats each. Normalized integers become [-1, 1] or [0, 1], other integers
  // keep their value (KHR_mesh_quantization). `where`: the JSON path of what refers to it. Throws FORMAT.
  std::vector<float> floats(int index, int components, const std::string &where);
  // The elements of a scalar accessor of unsigned integers.
  std::vector<uint32_t> indices(int index, const std::string &where);

private:
  struct Layout;
  Layout layout(int index, int components, const std::string &where);
  Span elements(int buffer_view, uint64_t offset, uint64_t count, Layout &layout, const std::string &where);
  template <class T, class Convert>
  std::vector<T> read(int index, int components, const std::string &where, Convert convert);
  template <class T, class Convert>
  void overlay_sparse(int index, const Layout &layout, std::vector<T> &values, Convert convert);

  GltfDocument &document;
  uint64_t max_elements;
};

} // namespace tyn::io
