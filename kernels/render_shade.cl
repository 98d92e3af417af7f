// SPDX-License-Identifier: Apache-2.0
// What happens where a path's ray ends: light is taken, one part of the surface is chosen, and the path goes on, enters a walk
// or ends. A part is chosen with the chance of its share, so weights stay at most 1 and each part's own densities serve for
// multiple importance sampling:
//   metal (share `metallic`)           walk between microfacets, Schlick's reflectance
//   dielectric interface               walk between microfacets: reflected, or below it:
//     share `transmission`, interior     a walk through the medium
//     share `transmission`, thin         straight on, or scattered to one side
//     the rest                           an opaque diffuse base (render_lobe.clh)
#include "render_interface.clh"
#include "render_lobe.clh"
#include "render_path.clh"

// What the shading kernel reads of the scene.
typedef struct {
  SceneGeometry geometry;
  Images images;
  Lights lights;
  global const TynMediumRecord *media;
  global const TynRenderMedium *render_media;
  global const TynMaterialRecord *materials;
  global const TynTextureRecord *textures;
} Scene;

// Where walks begin.
typedef struct {
  global TynWalkEntry *entries;
  global uint *paths;
} WalkQueue;

// ---- Light that is simply there -----------------------------------------------------------------------------------------

static void shade_environment(const TynRenderParameters *p, const Scene *scene, global const TynPathState *path,
                              global TynPathResult *result) {
  if (p->environment_hidden && path->bounces == 0)
    return;
  float2 uv = environment_uv(p, tyn_load3_global(path->direction));
  float weight = mis_weight_lobe(p, path->pdf, environment_pdf(p, &scene->images, &scene->lights, uv));
  float3 radiance = environment_at_uv(p, &scene->images, uv) * tyn_load3_global(path->throughput);
  path_add(result, path->event, radiance * weight);
}

static void shade_emission(const TynRenderParameters *p, global const TynPathState *path, global TynPathResult *result,
                           const Surface *s, global const TynMaterialRecord *m, float3 emission) {
  if (path_largest(emission) <= 0.0f || !(s->front || (m->flags & TYN_MATERIAL_DOUBLE_SIDED)))
    return;
  float cosine = tyn_dot(s->geometric, tyn_load3_global(path->direction));
  float weight = mis_weight_lobe(p, path->pdf, light_triangle_pdf(m, path->t, cosine));
  path_add(result, path->event, emission * tyn_load3_global(path->throughput) * weight);
}

// ---- Walks --------------------------------------------------------------------------------------------------------------

// Queues a walk that starts inside mesh `mesh` along `direction`. `triangle`: within the mesh, or TYN_NONE.
static void shade_enter(const TynRenderParameters *p, const Scene *scene, const Queues *queues, const WalkQueue *walks,
                        global TynPathState *path, uint index, float3 position, float3 direction, uint mesh,
                        uint triangle, const MaterialPoint *m, float3 throughput, Draws draws) {
  uint place = atomic_inc(queues->counters + TYN_COUNT_WALKS);
  global TynWalkEntry *entry = walks->entries + place;
  walks->paths[place] = index;
  uint medium = scene->geometry.meshes[mesh].medium;
  float g = scene->media[medium].g;
  path_store(entry->position, position);
  path_store(entry->direction, direction);
  path_store(entry->weight, throughput);
  entry->kind = TYN_ENTRY_INSIDE;
  entry->mesh = mesh;
  entry->triangle = triangle;
  entry->medium = medium;
  for (int c = 0; c < 3; ++c)
    entry->sigma_t[c] = -1.0f;
  if (m->multiscatter.x < 0.0f)
    path_store(entry->albedo, tyn_vec3(-1.0f, -1.0f, -1.0f));
  else
    path_store(entry->albedo, tyn_vec3(material_albedo(m->multiscatter.x, g), material_albedo(m->multiscatter.y, g),
                                       material_albedo(m->multiscatter.z, g)));
  entry->roughness = m->alpha;
  // every walk of a path has a path number of its own; that two of 2^32 walks share one has a chance of one half
  uint4 number = draws_bits(draws, TYN_DRAW_WALK, 0);
  entry->path[0] = number.x;
  entry->path[1] = number.y;
  entry->reserved = 1; // `path` is the whole number
  entry->reserved2 = 0;
  path->event = path_event(path->event, TYN_EVENT_SUBSURFACE);
  path->bounces = path->bounces + 1u;
}

// A ray that meets an interior's boundary from inside got in without crossing it: the camera is inside, or the mesh has a hole.
// The walk starts where the ray did, or where it came into the mesh's bounds.
static float3 shade_inside_start(global const TynPathState *path, global const TynMeshRecord *mesh) {
  float t = path->t_min;
  for (int axis = 0; axis < 3; ++axis) {
    float d = path->direction[axis];
    if (d == 0.0f)
      continue;
    float edge = d > 0.0f ? mesh->lower[axis] : mesh->upper[axis];
    t = fmax(t, (edge - path->origin[axis]) / d);
  }
  return tyn_load3_global(path->origin) + tyn_load3_global(path->direction) * fmin(t, path->t);
}

// ---- The first surface's layers -----------------------------------------------------------------------------------------

static void shade_first_hit(const Scene *scene, global const TynPathState *path, global TynPathResult *result,
                            const Surface *s, const MaterialPoint *m, int interior) {
  float3 color = m->base_color;
  if (interior) {
    float3 inside = m->multiscatter;
    if (inside.x < 0.0f)
      inside = tyn_load3_global(scene->render_media[scene->geometry.meshes[s->mesh].medium].color);
    color = mix(color, inside, m->transmission * (1.0f - m->metallic));
  }
  path_store(result->albedo, color);
  path_store(result->normal, s->shading);
  result->depth = path->t * path->cos_axis;
}

// ---- Below the interface ------------------------------------------------------------------------------------------------

// What the light that passed the interface meets.
#define BELOW_BASE 0
#define BELOW_INTERIOR 1
#define BELOW_STRAIGHT 2
#define BELOW_SCATTERED 3 // by a thin wall, forward or back

static int shade_choose_below(const MaterialPoint *m, global const TynMaterialRecord *record, int interior, float4 u) {
  if (u.y >= m->transmission)
    return BELOW_BASE;
  if (record->flags & TYN_MATERIAL_THIN)
    return u.z < record->thin_scatter ? BELOW_SCATTERED : BELOW_STRAIGHT;
  return interior ? BELOW_INTERIOR : BELOW_BASE;
}

kernel void shade(global TynPathState *paths, global TynPathResult *results, global const uint *queue, uint count,
                  global uint *next, global TynShadowRay *shadows, volatile global uint *counters,
                  global TynWalkEntry *walk_entries, global uint *walk_paths, global const TynTriangleRecord *triangles,
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
  const Scene scene = {{triangles, positions, normals, uvs, meshes},
                       {image_records, image_bytes, image_floats, decode},
                       {emitters, light_records, texels},
                       media,
                       render_media,
                       materials,
                       textures};
  const Queues queues = {next, shadows, counters};
  const WalkQueue walks = {walk_entries, walk_paths};
  const TynRenderParameters *p = &parameters;
  uint index = queue[i];
  global TynPathState *path = paths + index;
  global TynPathResult *result = results + index;

  if (path->triangle == TYN_NONE) {
    shade_environment(p, &scene, path, result);
    return;
  }
  float3 direction = tyn_load3_global(path->direction);
  Surface s = surface_at(&scene.geometry, path->triangle, path->u, path->v);
  global const TynMaterialRecord *record = materials + s.material;
  MaterialPoint m = material_at(&scene.images, textures, record, &s);
  surface_face(&s, direction);
  int thin = (record->flags & TYN_MATERIAL_THIN) != 0;
  uint medium = meshes[s.mesh].medium;
  int interior = !thin && medium != TYN_NONE && m.transmission > 0.0f;

  shade_emission(p, path, result, &s, record, m.emission);
  if (path->bounces == 0)
    shade_first_hit(&scene, path, result, &s, &m, interior);
  if (path->bounces >= p->max_bounces)
    return;

  Draws draws = draws_of(p, index, path->bounces);
  float4 u = draws_uniform(draws, TYN_DRAW_CHOICE, 0); // metal, below, thin wall, roulette
  float3 throughput = tyn_load3_global(path->throughput);
  throughput = throughput * path_roulette(path->bounces, throughput, u.w);
  if (!(path_largest(throughput) > 0.0f))
    return;

  if (interior && !s.front) {
    float3 start = shade_inside_start(path, meshes + s.mesh);
    shade_enter(p, &scene, &queues, &walks, path, index, start, direction, s.mesh, TYN_NONE, &m, throughput, draws);
    return;
  }

  Microsurface surface;
  surface.metal = u.x < m.metallic;
  surface.eta = interior ? media[medium].ior : record->ior;
  surface.alpha = m.alpha;
  surface.f0 = m.base_color;
  surface.frame = tyn_frame(s.shading);
  surface.geometric = s.geometric;
  int smooth = m.alpha < TYN_SMOOTH_ALPHA;
  int below = shade_choose_below(&m, record, interior, u);

  // a light sample serves the interface, if it is rough, and the diffuse lobe
  int through = below == BELOW_SCATTERED && draws_uniform(draws, TYN_DRAW_CHOICE, 1).x < record->thin_forward;
  Lobe lobe = {through ? -s.shading : s.shading, through ? -s.geometric : s.geometric, surface.eta,
               interior ? render_media[medium].transmittance : record->transmittance};
  LightSample light;
  light.valid = 0;
  int crossed = !surface.metal && surface.eta == 1.0f; // no interface
  if ((!smooth && !crossed) || (!surface.metal && (below == BELOW_BASE || below == BELOW_SCATTERED)))
    light = light_sample(p, &scene.geometry, &scene.images, &scene.lights, materials, textures, s.position, draws,
                         TYN_DRAW_LIGHT, 0, 1);
  float3 arriving = light.radiance * throughput;
  if (light.pdf > 0.0f)
    arriving = arriving / light.pdf;

  InterfacePath at;
  at.transmitted = 1;
  at.direction = direction;
  at.light = tyn_vec3(0.0f, 0.0f, 0.0f);
  if (!crossed) {
    int reaches = light.valid && !smooth && tyn_dot(light.direction, s.geometric) > 0.0f;
    at = interface_follow(p, &surface, direction, reaches ? &light : 0, draws);
  }
  uint specular = path_event(path->event, TYN_EVENT_SPECULAR);
  uint diffuse = path_event(path->event, TYN_EVENT_DIFFUSE);
  float3 by_interface = at.light * (light.valid ? arriving : tyn_vec3(0.0f, 0.0f, 0.0f));
  float3 by_lobe = tyn_vec3(0.0f, 0.0f, 0.0f);

  if (!at.transmitted) {
    path_continue(&queues, path, index, surface_leave(s.position, s.geometric, at.direction, s.size), at.direction,
                  at.pdf, throughput * at.weight, specular);
  } else if (below == BELOW_INTERIOR) {
    uint triangle = path->triangle - meshes[s.mesh].first_triangle;
    shade_enter(p, &scene, &queues, &walks, path, index, s.position, at.direction, s.mesh, triangle, &m, throughput,
                draws);
  } else if (below == BELOW_STRAIGHT) {
    path_continue(&queues, path, index, surface_leave(s.position, s.geometric, direction, s.size), direction, 0.0f,
                  throughput * m.base_color, specular);
  } else {
    float3 color = below == BELOW_BASE ? m.base_color : tyn_load3_global(record->thin_color);
    if (light.valid) {
      float value = lobe_value(&lobe, light.direction);
      by_lobe = arriving * color * (value * mis_weight_light(p, light.pdf, value));
    }
    float3 l = lobe_sample(&lobe, draws, TYN_DRAW_LOBE);
    path_continue(&queues, path, index, surface_leave(s.position, s.geometric, l, s.size), l, lobe_value(&lobe, l),
                  throughput * color, diffuse);
  }
  if (light.valid)
    path_connect(&queues, index, &light, s.position, s.geometric, s.size, specular, by_interface, diffuse, by_lobe);
}
