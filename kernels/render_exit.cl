// SPDX-License-Identifier: Apache-2.0
// Where walks have ended: light that left the medium is connected to a light and goes on along its next ray.
#include "render_lobe.clh"
#include "render_path.clh"

kernel void shade_exits(global TynPathState *paths, global const TynWalkExit *exits, global const TynWalkEntry *entries,
                        global const uint *walk_paths, uint count, global uint *next, global TynShadowRay *shadows,
                        volatile global uint *counters, global const TynTriangleRecord *triangles,
                        global const float *positions, global const float *normals, global const float *uvs,
                        global const TynMeshRecord *meshes, global const TynMediumRecord *media,
                        global const TynRenderMedium *render_media, global const TynMaterialRecord *materials,
                        global const TynTextureRecord *textures, global const TynImageRecord *image_records,
                        global const uchar4 *image_bytes, global const float4 *image_floats, global const float *decode,
                        global const TynEmitterRecord *emitters, global const TynLightRecord *light_records,
                        global const TynEnvironmentTexel *texels, TynRenderParameters parameters) {
  uint i = (uint)get_global_id(0);
  if (i >= count) return;
  global const TynWalkExit *walked = exits + i;
  if (walked->status != 0) return; // TYN_WALK_ESCAPED is all that goes on; the ledger has the rest
  const Geometry geometry = {triangles, positions, normals, uvs, meshes};
  const Images images = {image_records, image_bytes, image_floats, decode};
  const Lights lights = {emitters, light_records, texels};
  const Queues queues = {next, shadows, counters};
  const TynRenderParameters *p = &parameters;
  uint index = walk_paths[i];
  global TynPathState *path = paths + index;
  uint mesh = entries[i].mesh, medium = entries[i].medium;

  // the shade kernel has counted the walk: this is the bounce before
  Draws draws = draws_of(p, index, path->bounces - 1u);
  float3 throughput = tyn_load3_global(walked->weight);
  throughput = throughput * path_roulette(path->bounces, throughput, draws_uniform(draws, TYN_DRAW_EXIT_CHOICE, 0).x);
  if (!(path_largest(throughput) > 0.0f)) return;

  Lobe lobe = {tyn_load3_global(walked->shading_normal), tyn_load3_global(walked->geometric_normal), media[medium].ior,
               render_media[medium].transmittance};
  if (tyn_dot(lobe.shading, lobe.geometric) <= 0.0f) lobe.shading = lobe.geometric;
  Surface s = surface_at(&geometry, meshes[mesh].first_triangle + walked->triangle, walked->u, walked->v);
  float3 position = s.position;

  LightSample light = light_sample(p, &geometry, &images, &lights, materials, textures, position, draws, TYN_DRAW_EXIT_LIGHT);
  // TYN_EXIT_DIELECTRIC: what a direction can meet is left to the walk's own direction
  int refracted = p->exit == 1;
  if (light.valid && !(refracted && light.pdf > 0.0f)) {
    float value = lobe_value(&lobe, light.direction);
    float3 arriving = light.radiance * throughput * (value * mis_weight_light(p, light.pdf, value));
    if (light.pdf > 0.0f) arriving = arriving / light.pdf;
    float3 nothing = tyn_vec3(0.0f, 0.0f, 0.0f);
    path_connect(&queues, index, &light, position, lobe.geometric, s.size, path->event, arriving, path->event, nothing);
  }

  float3 l = refracted ? tyn_load3_global(walked->direction) : lobe_sample(&lobe, draws, TYN_DRAW_EXIT_LOBE);
  path->bounces = path->bounces - 1u; // path_continue counts it
  path_continue(&queues, path, index, surface_leave(position, lobe.geometric, l, s.size), l,
                refracted ? 0.0f : lobe_value(&lobe, l), throughput, path->event);
}
