// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
#include "scene/validate.hpp"

#include <cstring>

#include "core/argument.hpp"

namespace tyn {
namespace {

constexpr float HALF_PI = 1.57079637f; // pi / 2 rounded up to float: the caller's own M_PI / 2 passes
constexpr uint32_t MAX_IMAGE_SIDE = 32768;

void validate_texture(const char *name, const TynTexture &texture, size_t image_count) {
  const std::string prefix = std::string("TynMaterial::") + name;
  require_index_or_none((prefix + ".image").c_str(), texture.image, image_count, "images");
  require_choice((prefix + ".wrap_u").c_str(), texture.wrap_u, 3);
  require_choice((prefix + ".wrap_v").c_str(), texture.wrap_v, 3);
  require_choice((prefix + ".filter").c_str(), texture.filter, 2);
  for (int i = 0; i < 6; i++)
    require_finite(format("%s.transform[%d]", prefix.c_str(), i).c_str(), texture.transform[i]);
}

// Rotation and translation only: the three axes are perpendicular, of unit length and right-handed.
void validate_pose(const float (&m)[12]) {
  for (int i = 0; i < 12; i++)
    require_finite(format("TynCamera::world_from_camera[%d]", i).c_str(), m[i]);
  auto dot = [&](int a, int b) {
    return double(m[a]) * m[b] + double(m[a + 4]) * m[b + 4] + double(m[a + 8]) * m[b + 8];
  };
  for (int a = 0; a < 3; a++)
    for (int b = a; b < 3; b++)
      if (std::abs(dot(a, b) - (a == b)) > 2e-3)
        fail(TYN_ERROR_INVALID_ARGUMENT,
             "TynCamera::world_from_camera: the product of columns %d and %d is %g; it must be a rotation and a "
             "translation, without scale or shear",
             a, b, dot(a, b));
  const double determinant = double(m[0]) * (double(m[5]) * m[10] - double(m[6]) * m[9]) -
                             double(m[1]) * (double(m[4]) * m[10] - double(m[6]) * m[8]) +
                             double(m[2]) * (double(m[4]) * m[9] - double(m[5]) * m[8]);
  if (determinant < 0)
    fail(TYN_ERROR_INVALID_ARGUMENT,
         "TynCamera::world_from_camera mirrors (its determinant is %g); it must be a rotation", determinant);
}

void validate_pixels(const TynImage &image, size_t stride) {
  if (image.format != TYN_IMAGE_RGBA32F)
    return;
  for (uint32_t y = 0; y < image.height; y++)
    for (uint32_t x = 0; x < image.width; x++) {
      float pixel[4];
      std::memcpy(pixel, static_cast<const char *>(image.pixels) + y * stride + size_t(x) * sizeof pixel, sizeof pixel);
      for (int i = 0; i < 4; i++)
        if (!std::isfinite(pixel[i]))
          fail(TYN_ERROR_INVALID_ARGUMENT, "TynImage::pixels: channel %d of pixel (%u, %u) is %g; it must be finite", i,
               x, y, double(pixel[i]));
    }
}

} // namespace

size_t bytes_per_pixel(uint32_t format) { return format == TYN_IMAGE_RGBA32F ? 16 : 4; }

void validate(const TynImage &image) {
  require_between("TynImage::width", image.width, 1, MAX_IMAGE_SIDE);
  require_between("TynImage::height", image.height, 1, MAX_IMAGE_SIDE);
  require_choice("TynImage::format", image.format, 3);
  require_pointer("TynImage::pixels", image.pixels);
  const size_t row = image.width * bytes_per_pixel(image.format);
  const size_t stride = image.row_stride ? image.row_stride : row;
  if (stride < row)
    fail(TYN_ERROR_INVALID_ARGUMENT, "TynImage::row_stride is %zu; a row has %zu bytes", stride, row);
  size_t total;
  if (__builtin_mul_overflow(stride, size_t(image.height), &total))
    fail(TYN_ERROR_INVALID_ARGUMENT, "TynImage::row_stride is %zu: %u rows of it overflow", stride, image.height);
  validate_pixels(image, stride);
}

void validate(const TynMaterial &material, size_t image_count) {
  require_each(require_between, "TynMaterial::base_color", material.base_color, 0, 1);
  require_between("TynMaterial::metallic", material.metallic, 0, 1);
  require_between("TynMaterial::roughness", material.roughness, 0, 1);
  require_between("TynMaterial::ior", material.ior, 1, 4);
  require_between("TynMaterial::transmission", material.transmission, 0, 1);
  require_each(require_not_negative, "TynMaterial::emission", material.emission);
  require_finite("TynMaterial::normal_scale", material.normal_scale);
  require_choice("TynMaterial::double_sided", material.double_sided, 2);
  require_choice("TynMaterial::thin_walled", material.thin_walled, 2);
  require_between("TynMaterial::thin_scatter", material.thin_scatter, 0, 1);
  require_each(require_between, "TynMaterial::thin_scatter_color", material.thin_scatter_color, 0, 1);
  require_between("TynMaterial::thin_scatter_anisotropy", material.thin_scatter_anisotropy, -1, 1);
  if (!(material.multiscatter_color[0] < 0)) // a NaN is checked, and fails
    require_each(require_between, "TynMaterial::multiscatter_color", material.multiscatter_color, 0, 1);
  require_between("TynMaterial::scatter_strength", material.scatter_strength, 0, 1);
  validate_texture("base_color_texture", material.base_color_texture, image_count);
  validate_texture("metallic_roughness_texture", material.metallic_roughness_texture, image_count);
  validate_texture("normal_texture", material.normal_texture, image_count);
  validate_texture("emission_texture", material.emission_texture, image_count);
  validate_texture("transmission_texture", material.transmission_texture, image_count);
  validate_texture("multiscatter_color_texture", material.multiscatter_color_texture, image_count);
  validate_texture("scatter_strength_texture", material.scatter_strength_texture, image_count);
}

void validate(const TynLight &light) {
  require_choice("TynLight::type", light.type, 3);
  if (light.type != TYN_LIGHT_DIRECTIONAL)
    require_each(require_finite, "TynLight::position", light.position);
  if (light.type != TYN_LIGHT_POINT)
    require_unit("TynLight::direction", light.direction);
  require_each(require_not_negative, "TynLight::intensity", light.intensity);
  if (light.type != TYN_LIGHT_SPOT)
    return;
  if (!(light.outer_cone > 0 && light.outer_cone <= HALF_PI))
    fail(TYN_ERROR_INVALID_ARGUMENT, "TynLight::outer_cone is %g; it must be in (0, pi/2]", double(light.outer_cone));
  if (!(light.inner_cone >= 0 && light.inner_cone < light.outer_cone))
    fail(TYN_ERROR_INVALID_ARGUMENT, "TynLight::inner_cone is %g; it must be in [0, outer_cone = %g)",
         double(light.inner_cone), double(light.outer_cone));
}

void validate(const TynCamera &camera) {
  require_choice("TynCamera::type", camera.type, 2);
  validate_pose(camera.world_from_camera);
  if (camera.type == TYN_CAMERA_PERSPECTIVE) {
    if (!(camera.yfov > 0 && camera.yfov < 2 * HALF_PI))
      fail(TYN_ERROR_INVALID_ARGUMENT, "TynCamera::yfov is %g; it must be in (0, pi)", double(camera.yfov));
  } else {
    require_positive("TynCamera::ymag", camera.ymag);
  }
  require_not_negative("TynCamera::aspect_ratio", camera.aspect_ratio);
  require_not_negative("TynCamera::znear", camera.znear);
}

void validate(const TynEnvironment &environment, const std::vector<Image> &images) {
  require_each(require_not_negative, "TynEnvironment::radiance", environment.radiance);
  require_index_or_none("TynEnvironment::image", environment.image, images.size(), "images");
  if (environment.image != TYN_NONE && images[environment.image].format != TYN_IMAGE_RGBA32F)
    fail(TYN_ERROR_INVALID_ARGUMENT, "TynEnvironment::image is %u, whose format is %u; it must be TYN_IMAGE_RGBA32F",
         environment.image, images[environment.image].format);
  require_finite("TynEnvironment::rotation", environment.rotation);
  require_choice("TynEnvironment::hidden_from_camera", environment.hidden_from_camera, 2);
}

} // namespace tyn
