// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
//
// tyndall-render: a glTF model in, an OpenEXR image of it out.
#include "common/interrupt.hpp"
#include "common/json.hpp"
#include "common/outputs.hpp"
#include "common/progress.hpp"
#include "common/render_arguments.hpp"
#include "common/render_setup.hpp"

#include <tyndall/tyndall_io.h>

#include <algorithm>
#include <chrono>
#include <cstdarg>
#include <cstdio>

namespace {

using namespace tool;

constexpr const char *kName = "tyndall-render";
constexpr double kSliceSeconds = 0.5; // between two looks at the error estimate

double seconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

TynRenderStats render_stats(TynRenderer *renderer) {
  TynRenderStats stats = {};
  stats.size = sizeof stats;
  check(tyn_renderer_stats(renderer, &stats), tyn_scene_context(tyn_renderer_scene(renderer)));
  return stats;
}

// Renders in slices of about half a second, so that the bar can show the error; the bits do not depend on the slices.
class RenderLoop {
public:
  RenderLoop(TynRenderer *renderer, const RenderArguments &arguments)
      : renderer_(renderer), arguments_(arguments), progress_(kName, arguments.quiet) {}

  // Returns when a limit is reached or the user has had enough. The target error is the library's to judge, which does so
  // at sample counts that do not depend on the slices: it adds nothing more once the target is reached.
  void run() {
    uint32_t slice = 1; // the first is never cancelled: whatever happens there is an image
    while (!done()) {
      const auto slice_start = std::chrono::steady_clock::now();
      const uint32_t before = stats_.samples;
      run_slice(slice);
      if (stats_.samples == before)
        break;
      const double each = seconds_since(slice_start) / (stats_.samples - before);
      const double fitting = std::clamp(kSliceSeconds / std::max(each, 1e-6), 1.0, 65536.0);
      slice = std::min(static_cast<uint32_t>(fitting), 2 * slice);
    }
    progress_.finish();
  }

private:
  bool done() const {
    if (stats_.samples == 0)
      return false;
    if (interrupted() || (arguments_.samples && stats_.samples >= arguments_.samples))
      return true;
    return arguments_.time_limit > 0.0 && seconds_since(start_) >= arguments_.time_limit;
  }

  void run_slice(uint32_t samples) {
    if (arguments_.samples)
      samples = std::min(samples, arguments_.samples - stats_.samples);
    slice_ = samples;
    TynRenderBudget budget = tyn_render_budget();
    budget.samples = samples;
    budget.target_error = arguments_.target_error;
    if (arguments_.time_limit > 0.0)
      budget.seconds = std::max(arguments_.time_limit - seconds_since(start_), 1e-3);
    budget.progress = on_progress;
    budget.user = this;
    const TynStatus status = tyn_renderer_run(renderer_, &budget);
    if (status != TYN_ERROR_CANCELLED)
      check(status, tyn_scene_context(tyn_renderer_scene(renderer_)));
    stats_ = render_stats(renderer_);
    report(0.0);
  }

  static int32_t on_progress(void *user, double fraction) {
    RenderLoop &loop = *static_cast<RenderLoop *>(user);
    loop.report(fraction);
    return interrupted() && loop.stats_.samples > 0;
  }

  // How far along the limit is that will end the rendering.
  void report(double slice_fraction) {
    const double samples = stats_.samples + slice_fraction * slice_;
    ProgressState state;
    state.samples = static_cast<unsigned>(samples + 1e-6); // whole ones, also of a slice that is not over
    state.sample_goal = arguments_.samples;
    state.error = stats_.error;
    if (arguments_.samples)
      state.fraction = samples / arguments_.samples;
    if (arguments_.time_limit > 0.0)
      state.fraction = std::max(state.fraction, seconds_since(start_) / arguments_.time_limit);
    if (arguments_.target_error > 0.0 && stats_.error > 0.0) {
      // The error falls with the square root of the number of samples.
      const double ratio = arguments_.target_error / stats_.error;
      state.fraction = std::max(state.fraction, ratio * ratio);
    }
    state.fraction = std::min(state.fraction, 1.0);
    progress_.update(state);
  }

  TynRenderer *renderer_;
  const RenderArguments &arguments_;
  Progress progress_;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
  TynRenderStats stats_ = {};
  uint32_t slice_ = 1;
};

// One run of the tool.
class Job {
public:
  explicit Job(const RenderArguments &arguments) : arguments_(arguments) {}

  int run() {
    check_writable(arguments_.exr);
    if (!arguments_.png.empty())
      check_writable(arguments_.png);
    prepare();
    catch_interrupt();
    RenderLoop(renderer_.get(), arguments_).run();
    stats_ = render_stats(renderer_.get());
    say_where_time_went();
    warn_about_losses();
    write_images();
    if (arguments_.json)
      print_json(summary());
    else if (!arguments_.quiet)
      print_summary();
    return interrupted() ? kInterrupted : kOk;
  }

private:
  void prepare() {
    const auto start = std::chrono::steady_clock::now();
    context_ = create_context(arguments_.device);
    check(tyn_context_device(context_.get(), &device_), context_.get());
    say("device: %s, %u compute units", device_.name, device_.compute_units);

    LoadRequest request;
    request.path = arguments_.scene;
    request.media = arguments_.media;
    request.skip_lights = arguments_.no_lights;
    request.print_warnings = !arguments_.quiet;
    request.tool_name = kName;
    loaded_ = load_scene(context_.get(), request);
    TynScene *scene = loaded_.scene.get();
    if (!scene_info(scene).mesh_count)
      throw Error(kBadInput, arguments_.scene + ": there is no mesh in its scene");
    view_ = choose_view(scene, arguments_);
    light(scene);
    check(tyn_scene_commit(scene), context_.get());
    info_ = scene_info(scene);
    say("scene: %u meshes, %llu triangles, %u media, ready after %.2f s", info_.mesh_count,
        static_cast<unsigned long long>(info_.triangle_count), info_.medium_count, seconds_since(start));
    create_renderer(scene);
  }

  void light(TynScene *scene) {
    lighting_ = set_lighting(scene, arguments_, view_.camera);
    if (lighting_ == Lighting::kDefault)
      warn("nothing in the file gives light: a soft default light is used (--env sets another)");
    if (lighting_ == Lighting::kNone)
      warn("nothing gives light: the image will be black");
  }

  void create_renderer(TynScene *scene) {
    TynRenderOptions options = tyn_render_options();
    options.width = view_.width;
    options.height = view_.height;
    options.camera = view_.camera;
    options.seed = arguments_.seed;
    options.max_bounces = arguments_.max_bounces;
    options.exit = arguments_.exit;
    options.bssrdf = arguments_.bssrdf;
    TynRenderer *renderer = nullptr;
    check(tyn_renderer_create(scene, &options, &renderer), context_.get());
    renderer_.reset(renderer);
    say("film: %u x %u, camera: %s", view_.width, view_.height,
        view_.name.empty() ? "framed" : printable(view_.name).c_str());
  }

  // What the device did, and in the rest the host: compiling kernels, copying, waiting.
  void say_where_time_went() const {
    const TynRenderStats &s = stats_;
    const double total = std::max(s.seconds, 1e-9);
    const double measured = s.seconds_rays + s.seconds_walks + s.seconds_exits + s.seconds_shading;
    if (!(measured > 0.0))
      return;
    const auto percent = [total](double seconds) { return 100.0 * seconds / total; };
    say("%.1f s: rays %.0f %%, walks %.0f %%, exits %.0f %%, shading %.0f %%, host %.0f %%", s.seconds,
        percent(s.seconds_rays), percent(s.seconds_walks), percent(s.seconds_exits), percent(s.seconds_shading),
        percent(std::max(s.seconds - measured, 0.0)));
  }

  // Light that was lost is in the ledger; a user who does not read ledgers hears of it here.
  void warn_about_losses() {
    const TynLedger &ledger = stats_.ledger;
    const double entered = ledger.entered[0] + ledger.entered[1] + ledger.entered[2];
    const double leaked = ledger.leaked[0] + ledger.leaked[1] + ledger.leaked[2];
    char text[160];
    if (leaked > 1e-3 * entered) {
      std::snprintf(text, sizeof text,
                    "%.1f %% of the light that entered media left through holes in meshes "
                    "(tyndall-info shows them)",
                    100.0 * leaked / entered);
      warn(text);
    }
    if (ledger.lost_walks || stats_.nonfinite_paths) {
      std::snprintf(text, sizeof text, "%llu paths were lost numerically and left out",
                    static_cast<unsigned long long>(ledger.lost_walks + stats_.nonfinite_paths));
      warn(text);
    }
  }

  std::string media_names() const {
    std::string names;
    for (uint32_t i = 0; i < info_.medium_count; ++i) {
      TynMedium medium = tyn_medium();
      check(tyn_scene_medium(loaded_.scene.get(), i, &medium), context_.get());
      names += (i ? ", " : "") + std::string(medium.name ? medium.name : "");
    }
    return names;
  }

  // What went through media: walks, or the model in their place.
  const char *subsurface() const {
    return arguments_.bssrdf == TYN_NONE ? "walks" : tyn_bssrdf_model_name(arguments_.bssrdf);
  }

  void write_images() {
    const size_t slash = arguments_.scene.rfind('/');
    const std::string scene_name = slash == std::string::npos ? arguments_.scene : arguments_.scene.substr(slash + 1);
    const std::string media = media_names();
    const TynAttribute attributes[] = {{"scene", scene_name.c_str()},
                                       {"camera", view_.name.c_str()},
                                       {"media", media.c_str()},
                                       {"subsurface", subsurface()}};
    check(tyn_exr_write(renderer_.get(), arguments_.exr.c_str(), attributes, 4), context_.get());
    if (arguments_.png.empty())
      return;
    TynPngOptions options = tyn_png_options();
    options.exposure = static_cast<float>(arguments_.exposure);
    options.tone = arguments_.tone;
    check(tyn_png_write(renderer_.get(), arguments_.png.c_str(), &options), context_.get());
  }

  Json summary() const {
    Json outputs = {{"exr", arguments_.exr}};
    if (!arguments_.png.empty())
      outputs["png"] = arguments_.png;
    Json scene = {{"path", arguments_.scene}};
    scene.update(to_json(info_));
    return {{"tool", version_line(kName)},
            {"interrupted", interrupted()},
            {"outputs", outputs},
            {"width", stats_.width},
            {"height", stats_.height},
            {"samples", stats_.samples},
            {"seconds", stats_.seconds},
            {"seconds_rays", stats_.seconds_rays},
            {"seconds_walks", stats_.seconds_walks},
            {"seconds_exits", stats_.seconds_exits},
            {"seconds_shading", stats_.seconds_shading},
            {"error", stats_.error},
            {"seed", stats_.seed},
            {"subsurface", subsurface()},
            {"paths", stats_.paths},
            {"nonfinite_paths", stats_.nonfinite_paths},
            {"camera", view_.name.empty() ? Json(nullptr) : Json(view_.name)},
            {"default_light", lighting_ == Lighting::kDefault},
            {"device", to_json(device_)},
            {"scene", scene},
            {"ledger", to_json(stats_.ledger)},
            {"warnings", loaded_.warnings}};
  }

  void print_summary() const {
    char error[32] = "error unknown"; // one sample says nothing of it
    if (stats_.samples > 1)
      std::snprintf(error, sizeof error, "error %.2g %%", 100.0 * stats_.error);
    std::printf("%s%s: %u x %u, %u samples a pixel in %.1f s, %s\n", interrupted() ? "interrupted; " : "",
                arguments_.exr.c_str(), stats_.width, stats_.height, stats_.samples, stats_.seconds, error);
    if (!arguments_.png.empty())
      std::printf("%s\n", arguments_.png.c_str());
  }

  void warn(const std::string &message) {
    loaded_.warnings.push_back(message);
    if (!arguments_.quiet)
      std::fprintf(stderr, "%s: warning: %s\n", kName, message.c_str());
  }

  __attribute__((format(printf, 2, 3))) void say(const char *format, ...) const {
    if (!arguments_.verbose)
      return;
    std::fprintf(stderr, "%s: ", kName);
    va_list values;
    va_start(values, format);
    std::vfprintf(stderr, format, values);
    va_end(values);
    std::fputc('\n', stderr);
  }

  const RenderArguments &arguments_;
  Context context_; // declared first: it must go last
  LoadedScene loaded_;
  Renderer renderer_;
  TynDeviceInfo device_ = {};
  TynSceneInfo info_ = {};
  TynRenderStats stats_ = {};
  View view_ = {};
  Lighting lighting_ = Lighting::kScene;
};

int body(int argc, char **argv) {
  RenderArguments arguments;
  if (!parse_render_arguments(kName, argc, argv, arguments))
    return kOk;
  return Job(arguments).run();
}

} // namespace

int main(int argc, char **argv) { return tool::run(kName, argc, argv, body); }
