// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
//
// tyndall-demo-scene: makes demo.glb, a still life by candle and moon of things that light goes into. After Georges de
// La Tour, who painted a hand held before a candle, and its fingers red.
//
// Everything is modelled here from distance functions, at its real size: lengths in this file are centimetres, in the
// glTF file metres. Media are the measured ones of the library where there is one.
#include "common/tool.hpp"
#include "demo/glb.hpp"
#include "demo/hand.hpp"
#include "demo/mesher.hpp"
#include "demo/sculptures.hpp"

#include <cstdio>

namespace {

using namespace demo;
using Json = GlbWriter::Json;

constexpr const char *kName = "tyndall-demo-scene";
constexpr float kMetresPerCm = 0.01f;

// ---- materials ----

Json colour(float r, float g, float b) { return {r, g, b}; }

Json surface(const std::string &name, const Json &base_color, float metallic, float roughness) {
  Json rgba = base_color;
  rgba.push_back(1);
  return {{"name", name},
          {"pbrMetallicRoughness",
           {{"baseColorFactor", rgba}, {"metallicFactor", metallic}, {"roughnessFactor", roughness}}}};
}

Json glowing(const std::string &name, const Json &tint, float strength) {
  Json material = surface(name, colour(0, 0, 0), 0, 1);
  material["emissiveFactor"] = tint;
  material["extensions"]["KHR_materials_emissive_strength"]["emissiveStrength"] = strength;
  material["extensions"]["KHR_materials_ior"]["ior"] = 1; // nothing is mirrored in a flame
  return material;
}

// A surface that all light enters, over a medium given per mm. glTF says the extinction by the colour that is left
// after a distance, and the albedo by the colour that comes back from a thick layer: both are inverted here, so that a
// reader gets these coefficients back.
Json scattering(const std::string &name, const double (&sigma_s)[3], const double (&sigma_a)[3], float ior,
                float roughness) {
  Json material = surface(name, colour(1, 1, 1), 0, roughness);
  double densest = 0;
  for (int i = 0; i < 3; ++i)
    densest = std::max(densest, sigma_s[i] + sigma_a[i]);
  const double distance_mm = 1.0 / densest;
  Json left = Json::array(), returned = Json::array();
  for (int i = 0; i < 3; ++i) {
    const double sigma_t = sigma_s[i] + sigma_a[i];
    left.push_back(std::exp(-sigma_t * distance_mm));
    returned.push_back(tyn_color_from_albedo(static_cast<float>(sigma_s[i] / sigma_t), 0.0f));
  }
  Json &extensions = material["extensions"];
  extensions["KHR_materials_transmission"] = {{"transmissionFactor", 1}};
  extensions["KHR_materials_ior"] = {{"ior", ior}};
  extensions["KHR_materials_volume"] = {
      {"thicknessFactor", 1e-3 * distance_mm}, {"attenuationDistance", 1e-3 * distance_mm}, {"attenuationColor", left}};
  extensions["KHR_materials_scatter"] = {
      {"scatterStrengthFactor", 1}, {"multiscatterColorFactor", returned}, {"scatterAnisotropy", 0}};
  return material;
}

Json measured(const std::string &name, const char *preset, float roughness) {
  TynMedium medium = tyn_medium();
  if (tyn_medium_preset(preset, 1e-3, &medium) != TYN_OK)
    throw tool::Error(tool::kFailed, std::string("the library has no medium named ") + preset);
  const double sigma_s[3] = {medium.sigma_s[0], medium.sigma_s[1], medium.sigma_s[2]};
  const double sigma_a[3] = {medium.sigma_a[0], medium.sigma_a[1], medium.sigma_a[2]};
  return scattering(name, sigma_s, sigma_a, medium.ior, roughness);
}

// ---- the composition ----

Frame in_metres(Frame frame) {
  frame.origin = kMetresPerCm * frame.origin;
  return frame;
}

// Counts what it adds, and refuses an inside that is open.
class Scene {
public:
  Scene() : glb_(tool::version_line(kName)) {
    for (const char *name : {"KHR_materials_transmission", "KHR_materials_ior", "KHR_materials_volume",
                             "KHR_materials_scatter", "KHR_materials_emissive_strength", "KHR_lights_punctual"})
      glb_.use_extension(name);
  }

  void add(const std::string &name, const Mesh &mesh, const Json &material) {
    if (material.contains(Json::json_pointer("/extensions/KHR_materials_scatter")) && !is_closed(mesh))
      throw tool::Error(tool::kFailed, "the mesh of " + name + " is not closed");
    triangles_ += mesh.triangle_count();
    glb_.add_mesh(name, mesh, glb_.add_material(material), kMetresPerCm);
  }

  template <typename Shape>
  void add(const std::string &name, const Shape &shape, float cell, const Frame &place, const Json &material) {
    add(name, placed(polygonize(shape, shape.lower(), shape.upper(), cell), place), material);
  }

  GlbWriter &file() { return glb_; }
  size_t triangles() const { return triangles_; }

private:
  GlbWriter glb_;
  size_t triangles_ = 0;
};

void add_table(Scene &scene) {
  const Json wood = surface("table", colour(0.16f, 0.085f, 0.05f), 0, 0.42f);
  scene.add("table", quad({-45, 0, 40}, {45, 0, 40}, {45, 0, -26}, {-45, 0, -26}), wood);
  const Json plaster = surface("wall", colour(0.36f, 0.29f, 0.24f), 0, 0.9f);
  scene.add("wall", quad({-45, 0, -26}, {45, 0, -26}, {45, 40, -26}, {-45, 40, -26}), plaster);
}

constexpr Vec kCandle = {-2.7f, 0, -0.4f};
constexpr float kFlameHeight = 3.7f;
const Json kFlameColour = {1.0, 0.55, 0.22};

void add_candle(Scene &scene) {
  const double sigma_s[3] = {1.00, 0.95, 0.85}, sigma_a[3] = {0.0015, 0.0075, 0.032}; // honey-coloured wax
  const Frame place = turned(kCandle, 20);
  scene.add("candle", Candle(), 0.13f, place, scattering("wax", sigma_s, sigma_a, 1.44f, 0.45f));

  const float foot = Candle::kHollow + 0.1f, head = foot + 1.55f;
  const std::vector<std::pair<float, float>> wick = {
      {0, foot}, {0.08f, foot}, {0.07f, head - 0.2f}, {0.05f, head}, {0, head}};
  const Json char_black = surface("char", colour(0.02f, 0.017f, 0.015f), 0, 0.9f);
  scene.add("wick", placed(lathe(wick, 12), place), char_black);

  // A drop with a long tip.
  std::vector<std::pair<float, float>> flame;
  for (int i = 0; i <= 28; ++i) {
    const float t = i / 28.0f;
    const float radius = 0.6f * std::pow(std::sin(kPi * std::pow(t, 0.62f)), 1.25f);
    flame.push_back({radius, head + 0.05f + kFlameHeight * t});
  }
  flame.front().first = flame.back().first = 0;
  scene.add("flame", placed(lathe(flame, 24), place), glowing("flame", kFlameColour, 5));
}

// What the flame sends out, from a point above it: so near to no surface that what that reflects would be noise.
void add_candlelight(Scene &scene) {
  const Vec above = kCandle + Vec{-0.3f, Candle::kHollow + 1.7f + kFlameHeight + 0.7f, -0.6f};
  scene.file().add_light("candlelight", in_metres(looking(above, {0, 0, -1})),
                         {{"type", "point"}, {"color", kFlameColour}, {"intensity", 0.024}});
}

void add_hand(Scene &scene) {
  // The palm turned to the flame, the forearm coming in from the lower right.
  const Vec wrist = {10.3f, 5.3f, 7.2f};
  const Vec fingers = normalize({-0.62f, 0.78f, -0.12f});
  const Vec back = normalize(Vec{0.55f, 0.15f, 0.80f} - dot(Vec{0.55f, 0.15f, 0.80f}, fingers) * fingers);
  const Frame place = {cross(fingers, back), fingers, back, wrist};
  scene.add("hand", Hand(), 0.15f, place, measured("skin", "skin1", 0.5f));
}

void add_muse(Scene &scene) {
  const Frame place = turned({-13.0f, 3.2f, -7.0f}, 38);
  scene.add("muse", Muse(), 0.2f, place, measured("marble", "marble", 0.28f));
}

void add_hare(Scene &scene) {
  const double sigma_s[3] = {0.55, 0.70, 0.58}, sigma_a[3] = {0.060, 0.014, 0.040}; // green jade
  const Frame place = turned({-9.5f, 0, 8.0f}, -28);
  scene.add("hare", Hare(), 0.11f, place, scattering("jade", sigma_s, sigma_a, 1.6f, 0.16f));
}

void add_milk(Scene &scene) {
  const Frame place = turned({2.6f, 0, 10.5f}, 0);
  const std::vector<std::pair<float, float>> bowl = {{0, 0},         {1.9f, 0},      {1.95f, 0.25f}, {1.6f, 0.5f},
                                                     {2.6f, 0.9f},   {3.35f, 1.7f},  {3.75f, 2.6f},  {3.92f, 3.35f},
                                                     {3.98f, 3.48f}, {3.93f, 3.56f}, {3.82f, 3.50f}, {3.62f, 2.65f},
                                                     {3.2f, 1.8f},   {2.45f, 1.02f}, {1.3f, 0.72f},  {0, 0.7f}};
  scene.add("bowl", placed(lathe(bowl, 96), place), surface("brass", colour(0.86f, 0.62f, 0.28f), 1, 0.24f));
  const std::vector<std::pair<float, float>> milk = {{0, 0.74f},     {1.3f, 0.76f},  {2.42f, 1.06f}, {3.16f, 1.83f},
                                                     {3.58f, 2.66f}, {3.70f, 3.14f}, {3.68f, 3.17f}, {3.55f, 3.10f},
                                                     {3.3f, 3.06f},  {2.8f, 3.05f},  {1.5f, 3.05f},  {0, 3.05f}};
  scene.add("milk", placed(lathe(milk, 96), place), measured("milk", "wholemilk", 0.06f));
}

void add_plinth(Scene &scene) {
  const auto block = [](Vec p) { return box(p, {0, 1.6f, 0}, {5.2f, 1.6f, 3.4f}, 0.15f); };
  const Mesh mesh = polygonize(block, {-6, -1, -4.5f}, {6, 4, 4.5f}, 0.3f);
  scene.add("plinth", placed(mesh, turned({-13.0f, 0, -7.0f}, 38)),
            surface("slate", colour(0.05f, 0.05f, 0.055f), 0, 0.5f));
}

// Cold light through a window whose bars throw sharp shadows: they stay sharp on the table, soften in the marble, and
// turn red in the skin.
void add_moonlight(Scene &scene) {
  const Vec from = {-80, 78, 76}, at = {2, 6, -3};
  const Frame frame = looking(from, at - from);
  scene.file().add_light("moon", in_metres(frame),
                         {{"type", "spot"},
                          {"color", {0.74, 0.87, 1.0}},
                          {"intensity", 3.0},
                          {"spot", {{"innerConeAngle", 0.18}, {"outerConeAngle", 0.23}}}});
  const Json black = surface("window", colour(0.02f, 0.02f, 0.02f), 0, 1);
  Mesh bars;
  const Vec centre = mix(from, at, 0.6f);
  const auto bar = [&](float x, float y, float half_x, float half_y) {
    const Vec c = centre + x * frame.x + y * frame.y, h = half_x * frame.x, v = half_y * frame.y;
    append(bars, quad(c - h - v, c + h - v, c + h + v, c - h + v));
  };
  for (float x : {-8.1f, -2.7f, 2.7f, 8.1f})
    bar(x, 0, 0.42f, 18);
  for (float y : {-5.6f, 1.6f})
    bar(0, y, 18, 0.36f);
  scene.add("window", bars, black);
}

// A little light from above, so that shadows are not black.
void add_fill(Scene &scene) {
  const Json sky = glowing("sky", colour(0.62f, 0.76f, 1.0f), 0.35f);
  scene.add("sky", quad({-30, 32, 26}, {-30, 36, 8}, {6, 36, 8}, {6, 32, 26}), sky);
}

void add_camera(Scene &scene) {
  const Vec from = {-1.5f, 15.0f, 58.0f}, at = {-1.5f, 7.6f, 0};
  scene.file().add_camera("table", in_metres(looking(from, at - from)), radians(22.5f), 1.5f);
}

int body(int argc, char **argv) {
  const std::string argument = argc > 1 ? argv[1] : "";
  if (argc == 2 && (argument == "--help" || argument == "-h")) {
    std::printf("Makes the demo scene: a hand, wax, marble, jade and milk by candle and moon.\n\n"
                "  tyndall-demo-scene OUT.glb\n\n"
                "Example:\n"
                "  tyndall-demo-scene demo.glb && tyndall-render demo.glb -o demo.exr --png demo.png\n");
    return tool::kOk;
  }
  if (argc == 2 && argument == "--version") {
    std::printf("%s\n", tool::version_line(kName).c_str());
    return tool::kOk;
  }
  if (argc != 2 || argument.empty() || argument[0] == '-')
    throw tool::Error(tool::kUsage, "expected the name of the file to make (see --help)");
  Scene scene;
  add_table(scene);
  add_candle(scene);
  add_candlelight(scene);
  add_hand(scene);
  add_plinth(scene);
  add_muse(scene);
  add_hare(scene);
  add_milk(scene);
  add_moonlight(scene);
  add_fill(scene);
  add_camera(scene);
  scene.file().write(argument);
  std::printf("%s: %zu triangles\n", argument.c_str(), scene.triangles());
  return tool::kOk;
}

} // namespace

int main(int argc, char **argv) { return tool::run(kName, argc, argv, body); }
