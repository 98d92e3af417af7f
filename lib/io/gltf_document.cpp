// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
#include "io/gltf_document.hpp"

#include <cinttypes>

#include "io/base64.hpp"
#include "io/gltf_meshopt.hpp"

namespace tyn::io {
namespace {

// tinygltf keeps numbers of extensions as int or double; an integer that int does not hold must become a double.
void widen_integers(Json &value) {
  if (value.is_number_unsigned() ? value.get<uint64_t>() > INT32_MAX
                                 : value.is_number_integer() && value.get<int64_t>() < INT32_MIN)
    value = value.get<double>();
  if (value.is_structured())
    for (Json &child : value)
      widen_integers(child);
}

void widen_extensions(Json &value) {
  if (!value.is_structured())
    return;
  for (auto child = value.begin(); child != value.end(); ++child)
    value.is_object() && child.key() == "extensions" ? widen_integers(*child) : widen_extensions(*child);
}

// The JSON without what the loader reads itself or not at all.
std::string text_for_tinygltf(Json &root) {
  for (const char *key : {"buffers", "images", "animations", "skins", "extras"})
    root.erase(key);
  widen_extensions(root);
  return root.dump();
}

std::string first_line(const std::string &message) { return printable(message.substr(0, message.find('\n'))); }

void parse_model(tinygltf::Model &model, Json &root) {
  const std::string json = text_for_tinygltf(root);
  if (json.size() > UINT32_MAX)
    fail(TYN_ERROR_FORMAT, "the JSON is larger than 4 GiB");
  tinygltf::TinyGLTF parser;
  std::string error, warning;
  if (!parser.LoadASCIIFromString(&model, &error, &warning, json.data(), unsigned(json.size()), ""))
    fail(TYN_ERROR_FORMAT, "not a valid glTF file: %s", first_line(error).c_str());
}

// Moved, not copied: a data URI holds the whole of its data.
std::string take_uri(Json &object) {
  const auto uri = object.find("uri");
  return uri == object.end() ? std::string() : std::move(uri->get_ref<std::string &>());
}

std::vector<GltfImage> take_images(Json &root) {
  std::vector<GltfImage> images;
  if (!root.contains("images"))
    return images;
  for (Json &json : root["images"]) {
    GltfImage image;
    image.name = json.value("name", "");
    image.uri = take_uri(json);
    image.buffer_view = json.value("bufferView", -1);
    images.push_back(std::move(image));
  }
  return images;
}

} // namespace

// Where a buffer's bytes come from, as the JSON says.
struct GltfDocument::Source {
  std::string uri;
  uint64_t length;
};

std::vector<GltfDocument::Source> GltfDocument::take_sources(Json &root) {
  std::vector<Source> sources;
  if (root.contains("buffers"))
    for (Json &json : root["buffers"])
      sources.push_back({take_uri(json), json["byteLength"].get<uint64_t>()});
  return sources;
}

GltfDocument::GltfDocument(const std::string &model_path, const TynGltfOptions &limits, Warnings &warnings)
    : path(model_path), max_file_bytes(limits.max_file_bytes), file(read_file(model_path, limits.max_file_bytes)) {
  const GltfContainer container = split_container(file);
  Json root = parse_json(container.json);
  for (const std::string &name : check_extensions(root))
    warnings.add("the extension %s is not supported and ignored", name.c_str());
  check_schema(root);
  images = take_images(root);
  const std::vector<Source> sources = take_sources(root);
  parse_model(model, root);
  load_buffers(sources, container);
}

void GltfDocument::load_buffers(const std::vector<Source> &sources, const GltfContainer &container) {
  uint64_t left =
      max_file_bytes; // for all together, so that a thousand references to one file cannot exhaust the memory
  for (size_t i = 0; i < sources.size(); i++) {
    const std::string where = text("buffers[%zu]", i);
    Buffer buffer;
    if (sources[i].uri.empty()) {
      const bool chunk = i == 0 && container.binary.data;
      buffer.missing = !chunk;
      buffer.bytes = chunk ? container.binary : Span();
    } else {
      buffer.owned = read_uri(sources[i].uri, left, where + ".uri");
      buffer.bytes = {buffer.owned.data(), buffer.owned.size()};
      left -= std::min<uint64_t>(left, buffer.owned.size());
    }
    if (!buffer.missing && buffer.bytes.size < sources[i].length)
      fail(TYN_ERROR_FORMAT, "%s.byteLength is %" PRIu64 ", but its data has %zu bytes", where.c_str(),
           sources[i].length, buffer.bytes.size);
    buffer.bytes.size = buffer.missing ? 0 : size_t(sources[i].length); // what follows is padding
    buffers.push_back(std::move(buffer));
  }
}

Bytes GltfDocument::read_uri(const std::string &uri, uint64_t limit, const std::string &where) const {
  try {
    return is_data_uri(uri) ? decode_data_uri(uri) : read_file(confined_path(path, uri), limit);
  } catch (const Failure &failure) {
    throw Failure(failure.status, where + ": " + failure.what());
  }
}

Span GltfDocument::part(int index, uint64_t offset, uint64_t length, const std::string &where) const {
  const Buffer &buffer = buffers[size_t(index)];
  if (buffer.missing)
    fail(TYN_ERROR_FORMAT, "%s refers to buffers[%d], which has no uri", where.c_str(), index);
  uint64_t end;
  if (__builtin_add_overflow(offset, length, &end) || end > buffer.bytes.size)
    fail(TYN_ERROR_FORMAT, "%s covers %" PRIu64 " bytes from %" PRIu64 " on, but buffers[%d] has %zu", where.c_str(),
         length, offset, index, buffer.bytes.size);
  return {buffer.bytes.data + offset, size_t(length)};
}

Span GltfDocument::view(int index) {
  const tinygltf::BufferView &view = model.bufferViews[size_t(index)];
  const std::string where = text("bufferViews[%d]", index);
  MeshoptView compressed;
  if (!find_meshopt(view, compressed))
    return part(view.buffer, view.byteOffset, view.byteLength, where);
  auto found = decompressed.find(index);
  if (found == decompressed.end()) {
    const std::string inside = where + ".extensions.EXT_meshopt_compression";
    const Span source = part(compressed.buffer, compressed.offset, compressed.length, inside);
    found = decompressed.emplace(index, decode_meshopt(compressed, source, max_file_bytes, inside)).first;
  }
  const Bytes &bytes = found->second;
  if (view.byteLength > bytes.size())
    fail(TYN_ERROR_FORMAT, "%s.byteLength is %zu, but it decompresses to %zu bytes", where.c_str(), view.byteLength,
         bytes.size());
  return {bytes.data(), view.byteLength};
}

} // namespace tyn::io
