// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
#include "io/film.hpp"

#include <cinttypes>

namespace tyn::io {
namespace {

TynContext *context_of(TynRenderer *renderer) { return tyn_scene_context(tyn_renderer_scene(renderer)); }

TynRenderStats read_stats(TynRenderer *renderer) {
  TynRenderStats stats;
  std::memset(&stats, 0, sizeof stats);
  stats.size = sizeof stats;
  require_ok(context_of(renderer), tyn_renderer_stats(renderer, &stats));
  return stats;
}

void describe(TynRenderer *renderer, const TynRenderStats &stats, Film &film) {
  TynDeviceInfo device;
  std::memset(&device, 0, sizeof device);
  require_ok(context_of(renderer), tyn_context_device(context_of(renderer), &device));
  film.attributes.emplace_back("software", software());
  film.attributes.emplace_back("tyndall:seed", text("%" PRIu64, stats.seed));
  film.attributes.emplace_back("tyndall:samples", text("%" PRIu32, stats.samples));
  film.attributes.emplace_back("tyndall:seconds", text("%.3f", stats.seconds));
  film.attributes.emplace_back("tyndall:device", device.name);
}

} // namespace

std::string software() {
  const uint32_t version = tyn_version();
  return text("Tyndall %u.%u.%u", version / 10000, version / 100 % 100, version % 100);
}

FilmLayer read_layer(TynRenderer *renderer, uint32_t index, uint32_t width, uint32_t height) {
  FilmLayer layer;
  layer.index = index;
  layer.name = tyn_layer_name(index);
  layer.channels = tyn_layer_channels(index);
  layer.pixels.resize(size_t(width) * height * layer.channels);
  require_ok(context_of(renderer), tyn_renderer_read(renderer, index, layer.pixels.data(), layer.pixels.size()));
  return layer;
}

Film read_film(TynRenderer *renderer) {
  const TynRenderStats stats = read_stats(renderer);
  Film film;
  film.width = stats.width;
  film.height = stats.height;
  for (uint32_t layer = 0; layer < TYN_LAYER_COUNT; layer++)
    film.layers.push_back(read_layer(renderer, layer, stats.width, stats.height));
  describe(renderer, stats, film);
  return film;
}

} // namespace tyn::io

TynStatus tyn_exr_write(TynRenderer *renderer, const char *path, const TynAttribute *attributes, size_t count) {
  using namespace tyn::io;
  return guarded(tyn_scene_context(tyn_renderer_scene(renderer)), [&] {
    if (!path)
      fail(TYN_ERROR_INVALID_ARGUMENT, "path is NULL");
    if (count && !attributes)
      fail(TYN_ERROR_INVALID_ARGUMENT, "attributes is NULL, but count is %zu", count);
    for (size_t i = 0; i < count; i++)
      if (!attributes[i].name || !attributes[i].name[0] || !attributes[i].value)
        fail(TYN_ERROR_INVALID_ARGUMENT, "attributes[%zu] has no name or no value", i);
    Film film = read_film(renderer);
    for (size_t i = 0; i < count; i++)
      film.attributes.emplace_back(attributes[i].name, attributes[i].value);
    write_exr(film, path);
  });
}

TynStatus tyn_png_write(TynRenderer *renderer, const char *path, const TynPngOptions *given) {
  using namespace tyn::io;
  return guarded(tyn_scene_context(tyn_renderer_scene(renderer)), [&] {
    if (!path)
      fail(TYN_ERROR_INVALID_ARGUMENT, "path is NULL");
    const TynPngOptions options = copy_options("TynPngOptions", given, tyn_png_options());
    if (options.layer >= TYN_LAYER_COUNT)
      fail(TYN_ERROR_INVALID_ARGUMENT, "TynPngOptions::layer is %u; it must be in 0 .. %d", options.layer,
           TYN_LAYER_COUNT - 1);
    if (options.tone > TYN_TONE_ACES)
      fail(TYN_ERROR_INVALID_ARGUMENT, "TynPngOptions::tone is %u; it must be in 0 .. %d", options.tone, TYN_TONE_ACES);
    if (!(options.exposure >= -100 && options.exposure <= 100))
      fail(TYN_ERROR_INVALID_ARGUMENT, "TynPngOptions::exposure is %g stops; it must be in [-100, 100]",
           double(options.exposure));
    if (options.transparent > 1)
      fail(TYN_ERROR_INVALID_ARGUMENT, "TynPngOptions::transparent is %u; it must be 0 or 1", options.transparent);
    TynRenderStats stats;
    std::memset(&stats, 0, sizeof stats);
    stats.size = sizeof stats;
    require_ok(tyn_scene_context(tyn_renderer_scene(renderer)), tyn_renderer_stats(renderer, &stats));
    write_png(read_layer(renderer, options.layer, stats.width, stats.height), stats.width, stats.height, options, path);
  });
}
