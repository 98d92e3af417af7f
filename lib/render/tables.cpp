// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
#include "render/tables.hpp"

#include "render/environment.hpp"
#include "render/lights.hpp"
#include "render/materials.hpp"
#include "render/upload.hpp"

namespace tyn {

SceneTables make_tables(TynScene &scene, uint32_t strategy) {
  TextureTable textures;
  std::vector<TynMaterialRecord> materials;
  for (const Named<TynMaterial> &material : scene.materials)
    materials.push_back(material_record(material.value, textures));
  std::vector<TynRenderMedium> media;
  for (const TynMediumRecord &medium : scene.medium_records)
    media.push_back(render_medium(medium));
  const EnvironmentSampling environment = sample_environment(scene, strategy);
  const LightTable lights = light_table(scene, environment.power, materials);

  SceneTables tables;
  tables.images = upload_images(scene);
  tables.textures = upload(scene.context, textures.records());
  tables.materials = upload(scene.context, materials);
  tables.media = upload(scene.context, media);
  tables.emitters = upload(scene.context, lights.emitters);
  tables.lights = upload(scene.context, lights.lights);
  tables.texels = upload(scene.context, environment.texels);
  tables.emitter_count = uint32_t(lights.emitters.size());
  tables.environment_probability = float(lights.environment_probability);
  return tables;
}

} // namespace tyn
