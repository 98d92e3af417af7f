// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
#include "render/bssrdf_walks.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "bssrdf/model.hpp"
#include "render/upload.hpp"

namespace tyn {
namespace {

// Albedos of a family, by s = sqrt((1 - albedo) / (1 - g albedo)) from 0, white, to 1, black; denser towards white, where
// profiles change faster. A blend of neighbours is then within 1e-4 of the albedo that comes back.
constexpr uint32_t STEPS = 64;

// One local size for all launches, because PoCL compiles a kernel anew for each.
constexpr size_t LOCAL_SIZE = 64;

bool is_used(const TynScene &scene, uint32_t medium) {
  return std::any_of(scene.meshes.begin(), scene.meshes.end(), [&](const Mesh &mesh) { return mesh.medium == medium; });
}

// Whether a walk's albedo may be another than the medium's own.
bool has_albedos(const TynScene &scene, uint32_t medium) {
  for (const Mesh &mesh : scene.meshes)
    for (const uint32_t material : mesh.materials)
      if (mesh.medium == medium && material != TYN_NONE && !(scene.materials[material].value.multiscatter_color[0] < 0))
        return true;
  return false;
}

std::string describe(const TynScene &scene, uint32_t medium) {
  const std::string &name = scene.media[medium].name;
  return name.empty() ? format("medium %u", medium) : format("medium %u (\"%s\")", medium, name.c_str());
}

struct Node {
  double s, albedo;
};

// The albedos to prepare: the medium's own, and all that textures may ask for.
std::vector<Node> nodes_of(const TynMediumRecord &medium, bool all) {
  const double g = double(medium.g);
  std::vector<Node> nodes;
  for (const float own : medium.albedo) {
    const double albedo = double(own);
    nodes.push_back({std::sqrt((1 - albedo) / (1 - g * albedo)), albedo});
  }
  for (uint32_t k = 0; k < STEPS && all; k++) {
    const double t = double(k) / (STEPS - 1), s = t * t;
    nodes.push_back({s, (1 - s * s) / (1 - g * s * s)});
  }
  std::sort(nodes.begin(), nodes.end(), [](const Node &a, const Node &b) { return a.s < b.s; });
  nodes.erase(std::unique(nodes.begin(), nodes.end(), [](const Node &a, const Node &b) { return b.s - a.s < 1e-6; }),
              nodes.end());
  return nodes;
}

// Who is told that profiles are being prepared, and may cancel.
struct Caller {
  TynProgress progress;
  void *user;

  // The picture has not begun.
  static int32_t hears(void *self, double) {
    const Caller &caller = *static_cast<Caller *>(self);
    return caller.progress ? caller.progress(caller.user, 0.0) : 0;
  }
};

// Half-spaces of extinction 1 with these albedos.
PreparedBssrdf profiles_of(TynContext &context, Caller &caller, const TynMedium &medium, const std::vector<Node> &nodes,
                           uint32_t model) {
  std::vector<double> sigma_a, sigma_s;
  for (const Node &node : nodes) {
    sigma_a.push_back(1 - node.albedo);
    sigma_s.push_back(node.albedo);
  }
  TynSlabLayer layer = tyn_slab_layer();
  layer.sigma_a = sigma_a.data();
  layer.sigma_s = sigma_s.data();
  layer.g = double(medium.g);
  layer.phase = medium.phase;
  layer.ior = double(medium.ior);
  TynSlab slab = tyn_slab();
  slab.channel_count = uint32_t(nodes.size());
  slab.layer_count = 1;
  slab.layers = &layer;
  TynBssrdfOptions options = tyn_bssrdf_options();
  options.model = model;
  options.progress = &Caller::hears;
  options.user = &caller;
  return prepare_bssrdf(context, &slab, &options);
}

} // namespace

void require_bssrdf(const TynScene &scene, uint32_t model) {
  if (!find_model(model))
    fail(TYN_ERROR_INVALID_ARGUMENT, "TynRenderOptions::bssrdf is %u; it must be TYN_NONE or 0 .. %u: %s", model,
         TYN_BSSRDF_MODEL_COUNT - 1, model_names().c_str());
  if (model == TYN_BSSRDF_GAUSSIANS)
    fail(TYN_ERROR_INVALID_ARGUMENT,
         "TynRenderOptions::bssrdf is %u (%s), whose profile is the caller's and no "
         "medium's; the renderer takes the other models",
         model, tyn_bssrdf_model_name(model));
  for (uint32_t i = 0; i < scene.medium_records.size(); i++)
    for (int c = 0; c < 3 && is_used(scene, i); c++)
      if (!(scene.medium_records[i].sigma_t[c] > 0))
        fail(TYN_ERROR_INVALID_ARGUMENT,
             "%s has no extinction in channel %d; with TynRenderOptions::bssrdf sigma_a + sigma_s must be > 0",
             describe(scene, i).c_str(), c);
}

BssrdfWalks::BssrdfWalks(TynScene &owner, uint32_t model, TynProgress progress, void *user) : scene(owner) {
  Caller caller{progress, user};
  std::vector<Profile> all;
  std::vector<TynProfileFamily> records(scene.medium_records.size());
  std::vector<float> all_nodes;
  for (uint32_t i = 0; i < records.size(); i++) {
    if (!is_used(scene, i))
      continue;
    const std::vector<Node> own = nodes_of(scene.medium_records[i], has_albedos(scene, i));
    records[i] = {uint32_t(all.size()), uint32_t(own.size())};
    try {
      const PreparedBssrdf prepared = profiles_of(scene.context, caller, scene.media[i].value, own, model);
      all.insert(all.end(), prepared.profiles.begin(), prepared.profiles.end());
    } catch (const Failure &failure) {
      fail(failure.status, "%s: %s", describe(scene, i).c_str(), failure.what());
    }
    for (const Node &node : own)
      all_nodes.push_back(float(node.s));
  }
  // the interface is the renderer's own: indices of refraction do not matter here
  profiles.reset(new TynBssrdf(scene.context, {std::move(all), 1, 1, false}));
  families = upload(scene.context, records);
  nodes = upload(scene.context, all_nodes);
}

void BssrdfWalks::enqueue(const TynRenderParameters &parameters, uint32_t count, cl_mem entries, cl_mem exits,
                          cl_mem tallies) {
  const SceneBuffers &b = scene.buffers;
  scene.context.launch("render_bssrdf", "bssrdf_walks", count, LOCAL_SIZE, families, nodes, profiles->records,
                       profiles->terms, b.nodes, b.blocks, b.triangles, b.positions, b.normals, b.uvs, b.meshes,
                       b.media, entries, exits, tallies, parameters.seed[0], parameters.seed[1], count);
}

} // namespace tyn
