// SPDX-License-Identifier: Apache-2.0
// Where walks have ended: light that left the medium is connected to lights and goes on along its next ray. A walk costs much
// more than a ray, so each takes several light samples, whose rays are traced here.
#include "render_lobe.clh"
#include "render_path.clh"
#include "traverse.clh"

// What leaves a medium at one point.
typedef struct {
  Lobe lobe;
  float3 position, throughput;
  float size;          // see Surface
  int keeps_direction; // goes on along the walk's own direction, not one of the lobe
} Leaving;

// Light of one sample, nothing being in the way; `samples`: of how many.
static float3 exit_light(const TynRenderParameters *p, const Leaving *at, const LightSample *light, float samples) {
  // what a direction can meet is left to the walk's own, if it is kept
  if (!light->valid || (at->keeps_direction && light->pdf > 0.0f))
    return tyn_vec3(0.0f, 0.0f, 0.0f);
  float value = lobe_value(&at->lobe, light->direction);
  float density = light->pdf * samples;
  float weight = value * mis_weight_light(p, density, value) / (density > 0.0f ? density : samples);
  return light->radiance * at->throughput * weight;
}

kernel void shade_exits(global const TynBvhNode *nodes, global const TynTriangleBlock *blocks,
                        global TynPathState *paths, global TynPathResult *results, global const TynWalkExit *exits,
                        global const TynWalkEntry *entries, global const uint *walk_paths, uint count,
                        global uint *next, volatile global uint *counters, global const TynTriangleRecord *triangles,
                        global const float *positions, global const float *normals, global const float *uvs,
                        global const TynMeshRecord *meshes, global const TynMediumRecord *media,
                        global const TynRenderMedium *render_media, global const TynMaterialRecord *materials,
                        global const TynTextureRecord *textures, global const TynImageRecord *image_records,
                        global const uchar4 *image_bytes, global const float4 *image_floats, global const float *decode,
                        global const TynEmitterRecord *emitters, global const TynLightRecord *light_records,
                        global const TynEnvironmentTexel *texels, TynRenderParameters parameters) {
  uint i = (uint)get_global_id(0);
  if (i >= count)
    return;
  global const TynWalkExit *walked = exits + i;
  if (walked->status != TYN_WALK_ESCAPED)
    return; // the ledger has the rest
  const SceneGeometry geometry = {triangles, positions, normals, uvs, meshes};
  const Images images = {image_records, image_bytes, image_floats, decode};
  const Lights lights = {emitters, light_records, texels};
  const Queues queues = {next, 0, counters};
  const TynRenderParameters *p = &parameters;
  uint index = walk_paths[i];
  global TynPathState *path = paths + index;
  uint mesh = entries[i].mesh, medium = entries[i].medium;

  // the shade kernel has counted the walk: this is the bounce before
  Draws draws = draws_of(p, index, path->bounces - 1u);
  Leaving at;
  at.throughput = tyn_load3_global(walked->weight);
  at.throughput =
      at.throughput * path_roulette(path->bounces, at.throughput, draws_uniform(draws, TYN_DRAW_EXIT_CHOICE, 0).x);
  if (!(path_largest(at.throughput) > 0.0f))
    return;

  Surface s = surface_at(&geometry, meshes[mesh].first_triangle + walked->triangle, walked->u, walked->v);
  at.position = s.position;
  at.size = s.size;
  at.lobe.shading = tyn_load3_global(walked->shading_normal);
  at.lobe.geometric = tyn_load3_global(walked->geometric_normal);
  if (tyn_dot(at.lobe.shading, at.lobe.geometric) <= 0.0f)
    at.lobe.shading = at.lobe.geometric;
  at.lobe.ior = media[medium].ior;
  at.lobe.transmittance = render_media[medium].transmittance;

  // light that was not scattered still has the direction it came in with, refracted twice: clear glass stays clear, and where
  // it is smooth no light without size is met
  int ballistic = walked->scatterings == 0u;
  int smooth = at.lobe.ior == 1.0f || entries[i].roughness < TYN_SMOOTH_ALPHA;
  at.keeps_direction = ballistic || p->exit == TYN_EXIT_DIELECTRIC;
  uint samples = p->emitter_count == 0u || (ballistic && smooth) ? 0u : p->emitter_count == 1u ? 1u : LIGHT_SAMPLES;
  for (uint k = 0; k < samples; ++k) {
    LightSample light = light_sample(p, &geometry, &images, &lights, materials, textures, at.position, draws,
                                     TYN_DRAW_EXIT_LIGHT, k, samples);
    float3 arriving = exit_light(p, &at, &light, (float)samples);
    if (!(path_largest(arriving) > 0.0f))
      continue;
    LightRay ray = path_light_ray(&light, at.position, at.lobe.geometric, at.size);
    if (!tyn_trace_any(nodes, blocks, 0, ray.origin, ray.direction, 0.0f, ray.t_max))
      path_add(results + index, path->event, arriving);
  }

  float3 l =
      at.keeps_direction ? tyn_load3_global(walked->direction) : lobe_sample(&at.lobe, draws, TYN_DRAW_EXIT_LOBE);
  // against several light samples a followed direction counts for less: only the ratio of the densities matters
  float pdf = at.keeps_direction ? 0.0f : lobe_value(&at.lobe, l) / fmax((float)samples, 1.0f);
  path->bounces = path->bounces - 1u; // path_continue counts it
  path_continue(&queues, path, index, surface_leave(at.position, at.lobe.geometric, l, at.size), l, pdf, at.throughput,
                path->event);
}
