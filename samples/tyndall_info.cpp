// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
//
// tyndall-info: what a model, this machine and this library hold.
#include "common/help.hpp"
#include "common/json.hpp"
#include "common/loading.hpp"
#include "common/table.hpp"

#include <cmath>
#include <cstdio>

namespace {

using namespace tool;

constexpr const char *kName = "tyndall-info";

const char *const kAbout =
    R"(Shows what a glTF model holds: meshes and whether they are closed, media, cameras, lights.

  tyndall-info SCENE [--medium NAME|MATERIAL=NAME]... [--json]
  tyndall-info --devices [--json]
  tyndall-info --media [--json]

Examples:
  tyndall-info head.glb                     is it closed? which media are in it?
  tyndall-info head.glb --medium skin1      how far light goes in skin, against the size of the mesh
  tyndall-info --devices                    numbers and names for --device

Areas are in cm2, volumes in cm3, lengths in mm. A mesh should be closed for its inside to be defined;
an open one still renders, and light that leaks out of it is counted.
Exit status: 0 done, 1 failed, 2 wrong usage, 3 bad input file, 4 no device.
)";

struct Arguments {
  std::string scene;
  std::vector<std::string> media;
  std::string device;
  bool list_devices = false;
  bool list_media = false;
  bool json = false;
  bool quiet = false;
};

double length(const float (&lower)[3], const float (&upper)[3]) {
  double sum = 0.0;
  for (int i = 0; i < 3; ++i)
    sum += (double(upper[i]) - lower[i]) * (double(upper[i]) - lower[i]);
  return std::sqrt(sum);
}

TynMediumDescription describe(const TynMedium &medium, double metres_per_unit, double reference) {
  TynMediumDescription description = {};
  if (tyn_medium_describe(&medium, metres_per_unit, reference, &description) != TYN_OK)
    throw Error(kFailed, std::string("medium ") + medium.name + " cannot be described");
  return description;
}

std::string rgb(const double (&values)[3], double scale = 1.0, int digits = 3) {
  std::string text;
  for (int i = 0; i < 3; ++i)
    text += (i ? " " : "") + number(scale * values[i], digits);
  return text;
}

std::string rgb(const float (&values)[3], double scale = 1.0, int digits = 3) {
  const double wide[3] = {values[0], values[1], values[2]};
  return rgb(wide, scale, digits);
}

std::string count(uint64_t n, const char *what) { return std::to_string(n) + " " + what + (n == 1 ? "" : "s"); }

std::string name_or(const char *name, const std::string &otherwise) {
  return name && *name ? printable(name) : otherwise;
}

// ---- --devices ----

int show_devices(bool json) {
  uint32_t device_count = 0;
  check(tyn_device_count(&device_count), nullptr);
  Json list = Json::array();
  Table table;
  table.add({"", "device", "kind", "units", "memory", "lanes", "platform", "driver"});
  for (uint32_t i = 0; i < device_count; ++i) {
    TynDeviceInfo device = {};
    check(tyn_device_info(i, &device), nullptr);
    Json entry = {{"index", i}};
    entry.update(to_json(device));
    list.push_back(entry);
    table.add({std::to_string(i), printable(device.name), device.is_gpu ? "GPU" : "CPU",
               std::to_string(device.compute_units), number(double(device.memory) / (1 << 30), 3) + " GiB",
               std::to_string(device.lane_width), printable(device.platform), printable(device.driver)});
  }
  if (json)
    print_json({{"devices", list}});
  else if (device_count)
    table.print(0);
  if (!device_count)
    throw Error(
        kNoDevice,
        "there is no OpenCL device (Debian's pocl-opencl-icd makes one of the CPU; it needs a cache folder that can be "
        "written: POCL_CACHE_DIR, XDG_CACHE_HOME or HOME)");
  return kOk;
}

// ---- --media ----

Json coefficients(const TynMedium &medium, double metres_per_unit) {
  const double per_mm = 1e-3 / metres_per_unit; // 1/scene unit to 1/mm
  Json absorption = Json::array(), scattering = Json::array();
  for (int i = 0; i < 3; ++i) {
    absorption.push_back(medium.sigma_a[i] * per_mm);
    scattering.push_back(medium.sigma_s[i] * per_mm);
  }
  return {{"sigma_a_per_mm", absorption}, {"sigma_s_per_mm", scattering}, {"g", medium.g}, {"ior", medium.ior}};
}

int show_media(bool json) {
  Json list = Json::array();
  Table table;
  table.add(
      {"medium", "sigma_s 1/mm", "sigma_a 1/mm", "g", "ior", "mean free path mm", "diffusion length mm", "colour"});
  for (uint32_t i = 0; i < tyn_medium_preset_count(); ++i) {
    const char *name = tyn_medium_preset_name(i);
    TynMedium medium = tyn_medium();
    if (tyn_medium_preset(name, 1e-3, &medium) != TYN_OK)
      throw Error(kFailed, std::string("the medium ") + name + " is missing from this library");
    const TynMediumDescription lengths = describe(medium, 1e-3, 1.0);
    Json entry = {{"name", name}};
    entry.update(coefficients(medium, 1e-3));
    entry["mean_free_path_mm"] = triple(lengths.mean_free_path_mm);
    entry["diffusion_length_mm"] = triple(lengths.diffusion_length_mm);
    entry["diffuse_albedo"] = triple(lengths.diffuse_albedo);
    list.push_back(entry);
    table.add({name, rgb(medium.sigma_s), rgb(medium.sigma_a), number(medium.g, 3), number(medium.ior, 3),
               rgb(lengths.mean_free_path_mm), rgb(lengths.diffusion_length_mm), rgb(lengths.diffuse_albedo, 1.0, 2)});
  }
  if (json)
    print_json({{"media", list}});
  else
    table.print(0);
  return kOk;
}

// ---- a scene ----

// "closed", or what is wrong, and what the loader put right.
std::string shape(const TynMeshInfo &mesh) {
  std::string text = mesh.closed ? "closed" : "open";
  if (mesh.boundary_edges)
    text += ", " + count(mesh.boundary_edges, "boundary edge");
  if (mesh.nonmanifold_edges)
    text += ", " + count(mesh.nonmanifold_edges, "non-manifold edge");
  if (mesh.components > 1)
    text += ", " + count(mesh.components, "component");
  if (mesh.turned_triangles)
    text += ", " + count(mesh.turned_triangles, "triangle") + " turned";
  if (mesh.inverted_components)
    text += ", " + count(mesh.inverted_components, "component") + " turned inside out";
  if (mesh.overlapping_components)
    text += ", " + count(mesh.overlapping_components, "component") + " overlapping others";
  if (mesh.degenerate_triangles)
    text += ", " + count(mesh.degenerate_triangles, "degenerate triangle");
  if (mesh.duplicate_triangles)
    text += ", " + count(mesh.duplicate_triangles, "duplicate triangle");
  return text;
}

class SceneReport {
public:
  SceneReport(const std::string &path, const LoadedScene &loaded)
      : path_(path), loaded_(loaded), scene_(loaded.scene.get()), info_(scene_info(scene_)) {
    for (uint32_t i = 0; i < info_.mesh_count; ++i)
      meshes_.push_back(mesh_info(scene_, i));
  }

  void print_text() const {
    std::printf("%s: %s, %s, %s\n", printable(path_).c_str(),
                std::string(info_.mesh_count == 1 ? "1 mesh" : std::to_string(info_.mesh_count) + " meshes").c_str(),
                count(info_.triangle_count, "triangle").c_str(), size_text().c_str());
    print_meshes();
    print_media();
    print_cameras();
    std::printf("\nmaterials %u, images %u, lights %u, emissive triangles %u\n", info_.material_count,
                info_.image_count, info_.light_count, info_.emissive_triangle_count);
    if (!loaded_.warnings.empty())
      std::printf("%s, see above\n", count(loaded_.warnings.size(), "warning").c_str());
  }

  Json json() const {
    Json report = {{"path", path_}};
    report.update(to_json(info_));
    report["mesh_list"] = mesh_list();
    report["medium_list"] = medium_list();
    report["camera_list"] = camera_list();
    report["warnings"] = loaded_.warnings;
    return report;
  }

private:
  double metres() const { return info_.metres_per_unit; }

  std::string size_text() const {
    if (meshes_.empty())
      return "nothing to see";
    std::string text;
    for (int i = 0; i < 3; ++i)
      text += (i ? " x " : "") + number((double(info_.upper[i]) - info_.lower[i]) * metres() * 1e3, 4);
    return text + " mm";
  }

  TynMedium medium(uint32_t index) const {
    TynMedium result = tyn_medium();
    check(tyn_scene_medium(scene_, index, &result), tyn_scene_context(scene_));
    return result;
  }

  std::string medium_name(uint32_t index) const {
    if (index == TYN_NONE)
      return "-";
    return name_or(medium(index).name, "medium " + std::to_string(index));
  }

  void print_meshes() const {
    Table table;
    table.add({"mesh", "triangles", "area cm2", "volume cm3", "medium", "shape"});
    const double cm = metres() * 100.0;
    for (size_t i = 0; i < meshes_.size(); ++i) {
      const TynMeshInfo &mesh = meshes_[i];
      table.add({name_or(mesh.name, "mesh " + std::to_string(i)), std::to_string(mesh.triangle_count),
                 number(mesh.area * cm * cm), mesh.closed ? number(mesh.volume * cm * cm * cm) : "-",
                 medium_name(mesh.medium), shape(mesh)});
    }
    std::printf("\n");
    table.print(0);
  }

  // Light that cannot reach across a mesh leaves it looking solid; light that crosses freely leaves it looking clear.
  void print_media() const {
    Table table;
    table.add({"medium", "in mesh", "mean free path mm", "of the diagonal", "diffusion length mm", "of the diagonal",
               "colour", "ior"});
    bool any = false;
    for (size_t i = 0; i < meshes_.size(); ++i) {
      const TynMeshInfo &mesh = meshes_[i];
      if (mesh.medium == TYN_NONE)
        continue;
      any = true;
      const TynMedium inside = medium(mesh.medium);
      const TynMediumDescription d = describe(inside, metres(), length(mesh.lower, mesh.upper));
      table.add({medium_name(mesh.medium), name_or(mesh.name, "mesh " + std::to_string(i)), rgb(d.mean_free_path_mm),
                 rgb(d.mean_free_path_fraction, 1.0, 2), rgb(d.diffusion_length_mm),
                 rgb(d.diffusion_length_fraction, 1.0, 2), rgb(d.diffuse_albedo, 1.0, 2), number(inside.ior, 3)});
    }
    std::printf("\n");
    if (any)
      table.print(0);
    else
      std::printf("no medium: everything renders opaque (--medium NAME fills it)\n");
  }

  void print_cameras() const {
    for (uint32_t i = 0; i < info_.camera_count; ++i) {
      const TynCamera camera = scene_camera(i);
      const bool perspective = camera.type == TYN_CAMERA_PERSPECTIVE;
      std::printf("%scamera %u  %s, %s %s\n", i ? "" : "\n", i, name_or(camera.name, "unnamed").c_str(),
                  perspective ? "perspective" : "orthographic", view_text(camera).c_str());
    }
  }

  std::string view_text(const TynCamera &camera) const {
    if (camera.type == TYN_CAMERA_PERSPECTIVE)
      return number(camera.yfov * 180.0 / 3.14159265358979, 3) + " degrees high";
    return number(2e3 * camera.ymag * metres(), 3) + " mm high";
  }

  TynCamera scene_camera(uint32_t index) const {
    TynCamera camera = tyn_camera();
    check(tyn_scene_camera(scene_, index, &camera), tyn_scene_context(scene_));
    return camera;
  }

  Json mesh_list() const {
    Json list = Json::array();
    for (const TynMeshInfo &mesh : meshes_)
      list.push_back({{"name", mesh.name},
                      {"triangles", mesh.triangle_count},
                      {"vertices", mesh.vertex_count},
                      {"welded_vertices", mesh.welded_vertex_count},
                      {"closed", mesh.closed != 0},
                      {"boundary_edges", mesh.boundary_edges},
                      {"nonmanifold_edges", mesh.nonmanifold_edges},
                      {"degenerate_triangles", mesh.degenerate_triangles},
                      {"duplicate_triangles", mesh.duplicate_triangles},
                      {"components", mesh.components},
                      {"inverted_components", mesh.inverted_components},
                      {"overlapping_components", mesh.overlapping_components},
                      {"turned_triangles", mesh.turned_triangles},
                      {"medium", index_or_null(mesh.medium)},
                      {"material", index_or_null(mesh.material)},
                      {"area", mesh.area},
                      {"volume", mesh.volume},
                      {"lower", triple(mesh.lower)},
                      {"upper", triple(mesh.upper)}});
    return list;
  }

  static Json index_or_null(uint32_t index) { return index == TYN_NONE ? Json(nullptr) : Json(index); }

  Json medium_list() const {
    Json list = Json::array();
    for (uint32_t i = 0; i < info_.medium_count; ++i) {
      const TynMedium inside = medium(i);
      const TynMediumDescription d = describe(inside, metres(), 1.0);
      Json entry = {{"name", inside.name ? inside.name : ""}};
      entry.update(coefficients(inside, metres()));
      entry["albedo"] = triple(d.albedo);
      entry["diffuse_albedo"] = triple(d.diffuse_albedo);
      entry["mean_free_path_mm"] = triple(d.mean_free_path_mm);
      entry["transport_mean_free_path_mm"] = triple(d.transport_mean_free_path_mm);
      entry["diffusion_length_mm"] = triple(d.diffusion_length_mm);
      entry["meshes"] = uses(i);
      list.push_back(entry);
    }
    return list;
  }

  // The meshes that a medium fills, with its lengths as fractions of their diagonals.
  Json uses(uint32_t index) const {
    Json list = Json::array();
    for (size_t i = 0; i < meshes_.size(); ++i) {
      if (meshes_[i].medium != index)
        continue;
      const double diagonal = length(meshes_[i].lower, meshes_[i].upper);
      const TynMediumDescription d = describe(medium(index), metres(), diagonal);
      list.push_back({{"mesh", i},
                      {"diagonal", diagonal},
                      {"mean_free_path", triple(d.mean_free_path_fraction)},
                      {"transport_mean_free_path", triple(d.transport_mean_free_path_fraction)},
                      {"diffusion_length", triple(d.diffusion_length_fraction)}});
    }
    return list;
  }

  Json camera_list() const {
    Json list = Json::array();
    for (uint32_t i = 0; i < info_.camera_count; ++i) {
      const TynCamera camera = scene_camera(i);
      const bool perspective = camera.type == TYN_CAMERA_PERSPECTIVE;
      list.push_back({{"name", camera.name ? camera.name : ""},
                      {"type", perspective ? "perspective" : "orthographic"},
                      {perspective ? "yfov" : "ymag", perspective ? camera.yfov : camera.ymag},
                      {"aspect_ratio", camera.aspect_ratio}});
    }
    return list;
  }

  const std::string &path_;
  const LoadedScene &loaded_;
  const TynScene *scene_;
  TynSceneInfo info_;
  std::vector<TynMeshInfo> meshes_;
};

int show_scene(const Arguments &arguments) {
  const std::vector<MediumArgument> media = parse_media(arguments.media);
  const Context context = create_context(arguments.device);
  LoadRequest request;
  request.path = arguments.scene;
  request.media = media;
  request.print_warnings = !arguments.quiet;
  request.tool_name = kName;
  const LoadedScene loaded = load_scene(context.get(), request);
  const SceneReport report(arguments.scene, loaded);
  if (arguments.json)
    print_json(report.json());
  else
    report.print_text();
  return kOk;
}

int body(int argc, char **argv) {
  Arguments arguments;
  CLI::App app(kAbout);
  app.add_option("SCENE", arguments.scene, "glTF 2.0 model, .gltf or .glb");
  app.add_option("--medium", arguments.media,
                 "fill what is not metal, or one material, with a\nmeasured medium (repeatable)")
      ->type_name("NAME|MATERIAL=NAME")
      ->expected(1)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
  app.add_flag("--devices", arguments.list_devices, "list the OpenCL devices");
  app.add_flag("--media", arguments.list_media, "list the measured media");
  app.add_option("--device", arguments.device, "OpenCL device (TYNDALL_DEVICE, else 0)")->type_name("INDEX|NAME");
  app.add_flag("--json", arguments.json, "one JSON object on standard output, and nothing else");
  app.add_flag("-q,--quiet", arguments.quiet, "no warnings");
  if (!parse_or_answer(app, kName, argc, argv))
    return kOk;
  const int asked = !arguments.scene.empty() + arguments.list_devices + arguments.list_media;
  if (asked != 1)
    throw Error(kUsage, "expected one of SCENE, --devices and --media (see --help)");
  if (arguments.list_devices)
    return show_devices(arguments.json);
  if (arguments.list_media)
    return show_media(arguments.json);
  return show_scene(arguments);
}

} // namespace

int main(int argc, char **argv) { return tool::run(kName, argc, argv, body); }
