// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
#include "io/gltf_meshopt.hpp"

#include <cinttypes>

#include <meshoptimizer.h>

#include "io/failure.hpp"
#include "io/gltf_value.hpp"

namespace tyn::io {
namespace {

// The conditions that meshoptimizer asserts instead of checking.
void check_layout(const MeshoptView &view, uint64_t max_bytes, const std::string &where) {
  const bool attributes = view.mode == "ATTRIBUTES";
  const bool fits =
      attributes ? view.stride > 0 && view.stride % 4 == 0 && view.stride <= 256 : view.stride == 2 || view.stride == 4;
  if (!fits)
    fail(TYN_ERROR_FORMAT, "%s.byteStride is %" PRIu64 ", which mode %s does not allow", where.c_str(), view.stride,
         view.mode.c_str());
  if (view.mode == "TRIANGLES" && view.count % 3 != 0)
    fail(TYN_ERROR_FORMAT, "%s.count is %" PRIu64 "; it must be a multiple of 3", where.c_str(), view.count);
  if (view.stride * view.count > max_bytes) // no overflow: the schema limits both to 32 bits
    fail(TYN_ERROR_FORMAT, "%s holds %" PRIu64 " bytes; at most %" PRIu64 " are read", where.c_str(),
         view.stride * view.count, max_bytes);
}

void check_filter(const MeshoptView &view, const std::string &where) {
  if (view.filter.empty() || view.filter == "NONE")
    return;
  if (view.mode != "ATTRIBUTES")
    fail(TYN_ERROR_FORMAT, "%s.filter is %s, which mode %s does not allow", where.c_str(), view.filter.c_str(),
         view.mode.c_str());
  const bool fits = view.filter == "OCTAHEDRAL"   ? view.stride == 4 || view.stride == 8
                    : view.filter == "QUATERNION" ? view.stride == 8
                                                  : true;
  if (!fits)
    fail(TYN_ERROR_FORMAT, "%s.byteStride is %" PRIu64 ", which the filter %s does not allow", where.c_str(),
         view.stride, view.filter.c_str());
}

void apply_filter(const MeshoptView &view, Bytes &bytes) {
  if (view.filter == "OCTAHEDRAL")
    meshopt_decodeFilterOct(bytes.data(), size_t(view.count), size_t(view.stride));
  else if (view.filter == "QUATERNION")
    meshopt_decodeFilterQuat(bytes.data(), size_t(view.count), size_t(view.stride));
  else if (view.filter == "EXPONENTIAL")
    meshopt_decodeFilterExp(bytes.data(), size_t(view.count), size_t(view.stride));
}

} // namespace

bool find_meshopt(const tinygltf::BufferView &view, MeshoptView &result) {
  auto found = view.extensions.find("KHR_meshopt_compression");
  if (found == view.extensions.end())
    found = view.extensions.find("EXT_meshopt_compression");
  if (found == view.extensions.end())
    return false;
  const tinygltf::Value &value = found->second;
  result.buffer = int(number(value, "buffer", 0));
  result.offset = uint64_t(number(value, "byteOffset", 0));
  result.length = uint64_t(number(value, "byteLength", 0));
  result.stride = uint64_t(number(value, "byteStride", 0));
  result.count = uint64_t(number(value, "count", 0));
  result.mode = string(value, "mode");
  result.filter = string(value, "filter");
  return true;
}

Bytes decode_meshopt(const MeshoptView &view, Span source, uint64_t max_bytes, const std::string &where) {
  check_layout(view, max_bytes, where);
  check_filter(view, where);
  Bytes bytes(size_t(view.stride * view.count));
  if (view.count == 0)
    return bytes;
  const size_t count = size_t(view.count), stride = size_t(view.stride);
  int error = 0;
  if (view.mode == "ATTRIBUTES")
    error = meshopt_decodeVertexBuffer(bytes.data(), count, stride, source.data, source.size);
  else if (view.mode == "TRIANGLES")
    error = meshopt_decodeIndexBuffer(bytes.data(), count, stride, source.data, source.size);
  else
    error = meshopt_decodeIndexSequence(bytes.data(), count, stride, source.data, source.size);
  if (error != 0)
    fail(TYN_ERROR_FORMAT, "%s cannot be decompressed: %s", where.c_str(),
         error == -1 ? "it is damaged, or written by a later version of meshoptimizer" : "it is damaged");
  apply_filter(view, bytes);
  return bytes;
}

} // namespace tyn::io
