// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
#include "io/gltf_accessor.hpp"

#include <algorithm>
#include <cinttypes>
#include <cstring>

namespace tyn::io {
namespace {

template <class T>
T load(const uint8_t *bytes) {
  T value; // glTF data is little-endian, and need not be aligned
  std::memcpy(&value, bytes, sizeof value);
  return value;
}

float load_float(const uint8_t *bytes, int type, bool normalized) {
  switch (type) {
  case TINYGLTF_COMPONENT_TYPE_BYTE: {
    const float value = load<int8_t>(bytes);
    return normalized ? std::max(value / 127.0f, -1.0f) : value;
  }
  case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE: {
    const float value = load<uint8_t>(bytes);
    return normalized ? value / 255.0f : value;
  }
  case TINYGLTF_COMPONENT_TYPE_SHORT: {
    const float value = load<int16_t>(bytes);
    return normalized ? std::max(value / 32767.0f, -1.0f) : value;
  }
  case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT: {
    const float value = load<uint16_t>(bytes);
    return normalized ? value / 65535.0f : value;
  }
  case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT:
    return float(load<uint32_t>(bytes));
  default:
    return load<float>(bytes);
  }
}

uint32_t load_index(const uint8_t *bytes, int type) {
  if (type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE)
    return load<uint8_t>(bytes);
  return type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT ? load<uint16_t>(bytes) : load<uint32_t>(bytes);
}

bool is_index_type(int type) {
  return type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE || type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT ||
         type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT;
}

// Bytes of one component, 0 for a type that glTF does not have.
size_t component_size(int type) {
  switch (type) {
  case TINYGLTF_COMPONENT_TYPE_BYTE:
  case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
    return 1;
  case TINYGLTF_COMPONENT_TYPE_SHORT:
  case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
    return 2;
  case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT:
  case TINYGLTF_COMPONENT_TYPE_FLOAT:
    return 4;
  default:
    return 0;
  }
}

int component_count(int type) {
  switch (type) {
  case TINYGLTF_TYPE_SCALAR:
    return 1;
  case TINYGLTF_TYPE_VEC2:
    return 2;
  case TINYGLTF_TYPE_VEC3:
    return 3;
  case TINYGLTF_TYPE_VEC4:
    return 4;
  default:
    return 0;
  }
}

} // namespace

bool elements_fit(uint64_t offset, uint64_t stride, uint64_t count, uint64_t size, uint64_t available) {
  if (count == 0)
    return offset <= available;
  uint64_t end;
  return !__builtin_mul_overflow(stride, count - 1, &end) && !__builtin_add_overflow(end, offset, &end) &&
         !__builtin_add_overflow(end, size, &end) && end <= available;
}

// How the elements of an accessor lie in memory.
struct GltfAccessors::Layout {
  std::string where; // for messages
  int type;          // of a component
  bool normalized;
  size_t components, component_bytes, size, stride;
};

GltfAccessors::Layout GltfAccessors::layout(int index, int components, const std::string &where) {
  const tinygltf::Accessor &accessor = document.model.accessors[size_t(index)];
  Layout result;
  result.where = text("%s (accessors[%d])", where.c_str(), index);
  result.type = accessor.componentType;
  result.normalized = accessor.normalized;
  result.components = size_t(components);
  result.component_bytes = component_size(accessor.componentType);
  result.size = result.stride = result.components * result.component_bytes;
  if (component_count(accessor.type) != components)
    fail(TYN_ERROR_FORMAT, "%s has the wrong type; it must be %s", result.where.c_str(),
         components == 1 ? "SCALAR" : text("VEC%d", components).c_str());
  if (result.component_bytes == 0)
    fail(TYN_ERROR_FORMAT, "%s has componentType %d, which glTF does not know", result.where.c_str(), result.type);
  if (accessor.count > max_elements)
    fail(TYN_ERROR_FORMAT, "%s has %zu elements; at most %" PRIu64 " are read", result.where.c_str(), accessor.count,
         max_elements);
  return result;
}

// The bytes from an accessor's first element on. layout.stride becomes the buffer view's.
Span GltfAccessors::elements(int buffer_view, uint64_t offset, uint64_t count, Layout &layout,
                             const std::string &where) {
  const size_t stride = document.model.bufferViews[size_t(buffer_view)].byteStride;
  layout.stride = stride ? stride : layout.size;
  if (layout.stride < layout.size)
    fail(TYN_ERROR_FORMAT, "bufferViews[%d].byteStride is %zu, but an element of %s has %zu bytes", buffer_view, stride,
         where.c_str(), layout.size);
  const Span view = document.view(buffer_view);
  if (!elements_fit(offset, layout.stride, count, layout.size, view.size))
    fail(TYN_ERROR_FORMAT,
         "%s: %" PRIu64 " elements of %zu bytes, %zu apart, from byte %" PRIu64 " on do not fit into the %zu bytes of "
         "bufferViews[%d]",
         where.c_str(), count, layout.size, layout.stride, offset, view.size, buffer_view);
  return {view.data + offset, size_t(view.size - offset)};
}

template <class T, class Convert>
std::vector<T> GltfAccessors::read(int index, int components, const std::string &where, Convert convert) {
  const tinygltf::Accessor &accessor = document.model.accessors[size_t(index)];
  Layout layout = this->layout(index, components, where);
  // Zeros cost no bytes in the file: what a few characters of JSON may allocate has a lower limit.
  constexpr uint64_t MOST_ZEROS = 1 << 24;
  if (accessor.bufferView < 0 && accessor.count > MOST_ZEROS)
    fail(TYN_ERROR_FORMAT, "%s has %zu elements and no bufferView; at most %" PRIu64 " are read", layout.where.c_str(),
         accessor.count, MOST_ZEROS);
  Span source;
  if (accessor.bufferView >= 0)
    source = elements(accessor.bufferView, accessor.byteOffset, accessor.count, layout, layout.where);
  std::vector<T> values(accessor.count * layout.components); // zeros if there is no buffer view
  for (size_t i = 0; source.data && i < accessor.count; i++)
    for (size_t c = 0; c < layout.components; c++)
      values[i * layout.components + c] = convert(source.data + i * layout.stride + c * layout.component_bytes, layout);
  if (accessor.sparse.isSparse)
    overlay_sparse(index, layout, values, convert);
  return values;
}

template <class T, class Convert>
void GltfAccessors::overlay_sparse(int index, const Layout &layout, std::vector<T> &values, Convert convert) {
  const tinygltf::Accessor &accessor = document.model.accessors[size_t(index)];
  const auto &sparse = accessor.sparse;
  const size_t count = size_t(sparse.count);
  Layout of_indices = layout, of_values = layout;
  of_indices.type = sparse.indices.componentType;
  of_indices.size = component_size(sparse.indices.componentType);
  if (!is_index_type(sparse.indices.componentType))
    fail(TYN_ERROR_FORMAT, "%s.sparse.indices has componentType %d; it must be an unsigned integer",
         layout.where.c_str(), sparse.indices.componentType);
  const Span positions = elements(sparse.indices.bufferView, uint64_t(sparse.indices.byteOffset), count, of_indices,
                                  layout.where + ".sparse.indices");
  const Span source = elements(sparse.values.bufferView, uint64_t(sparse.values.byteOffset), count, of_values,
                               layout.where + ".sparse.values");
  for (size_t i = 0; i < count; i++) {
    const uint32_t element = load_index(positions.data + i * of_indices.stride, of_indices.type);
    if (element >= accessor.count)
      fail(TYN_ERROR_FORMAT, "%s.sparse.indices: element %zu is %u, but the accessor has %zu elements",
           layout.where.c_str(), i, element, accessor.count);
    for (size_t c = 0; c < layout.components; c++)
      values[element * layout.components + c] =
          convert(source.data + i * of_values.stride + c * layout.component_bytes, layout);
  }
}

std::vector<float> GltfAccessors::floats(int index, int components, const std::string &where) {
  return read<float>(index, components, where, [](const uint8_t *bytes, const Layout &layout) {
    return load_float(bytes, layout.type, layout.normalized);
  });
}

std::vector<uint32_t> GltfAccessors::indices(int index, const std::string &where) {
  const int type = document.model.accessors[size_t(index)].componentType;
  if (!is_index_type(type))
    fail(TYN_ERROR_FORMAT, "%s (accessors[%d]) has componentType %d; it must be an unsigned integer", where.c_str(),
         index, type);
  return read<uint32_t>(index, 1, where,
                        [](const uint8_t *bytes, const Layout &layout) { return load_index(bytes, layout.type); });
}

} // namespace tyn::io
