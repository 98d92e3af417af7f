// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
#include "bench/walk/report.hpp"

#include <algorithm>
#include <cstdio>

#include <nlohmann/json.hpp>

namespace bench {

namespace {

using Json = nlohmann::ordered_json;

double median(std::vector<double> values) {
  if (values.empty())
    return NAN;
  std::sort(values.begin(), values.end());
  size_t half = values.size() / 2;
  return values.size() % 2 ? values[half] : 0.5 * (values[half - 1] + values[half]);
}

struct Summary {
  double median_ratio = NAN, least_ratio = NAN;
  double slowdown = NAN,
         plain_slowdown = NAN; // time of a scattering in sphere-600k / in sphere-10k: median over the media
  double worst_disagreement = 0;
};

Summary summarize(const std::vector<Result> &results) {
  Summary summary;
  std::vector<double> ratios, slowdowns, plain_slowdowns;
  for (const Result &r : results) {
    ratios.push_back(r.ratio());
    summary.least_ratio = std::fmin(summary.least_ratio, r.ratio());
    summary.worst_disagreement = std::max(summary.worst_disagreement, r.disagreement());
    if (r.what.mesh != "sphere-10k")
      continue;
    for (const Result &large : results)
      if (large.what.mesh == "sphere-600k" && large.what.same_medium(r.what)) {
        slowdowns.push_back(r.ours.scatterings_per_second() / large.ours.scatterings_per_second());
        plain_slowdowns.push_back(r.plain.scatterings_per_second() / large.plain.scatterings_per_second());
      }
  }
  summary.median_ratio = median(ratios);
  summary.slowdown = median(slowdowns);
  summary.plain_slowdown = median(plain_slowdowns);
  return summary;
}

// As one would write it: 0.8 and not 0.800000011920929.
double plain_decimal(float value) { return std::round(1e6 * double(value)) / 1e6; }

Json to_json(const Rate &rate) {
  return {{"walks", rate.sums.walks},
          {"fastest_walks", rate.fastest.walks},
          {"fastest_seconds", rate.seconds},
          {"scatterings_per_second", rate.scatterings_per_second()},
          {"walks_per_second", rate.walks_per_second()},
          {"scatterings_per_walk", rate.scatterings_per_walk()},
          {"rays_per_scattering", rate.rays_per_scattering()},
          {"escaped", {{"mean", rate.sums.mean()}, {"standard_error", rate.sums.standard_error()}}},
          {"variance_seconds", rate.variance_seconds()}};
}

Json to_json(const Case &c) {
  return {{"mesh", c.mesh},
          {"width", plain_decimal(c.width)},
          {"g", plain_decimal(c.g)},
          {"ior", plain_decimal(c.ior)},
          {"albedo", plain_decimal(c.albedo)}};
}

Json to_json(const Result &r) {
  Json json = to_json(r.what);
  json["ours"] = to_json(r.ours);
  json["plain"] = to_json(r.plain);
  json["free_flights"] = r.free_flights();
  json["ratio"] = r.ratio();
  json["disagreement"] = r.disagreement();
  return json;
}

Json to_json(const OneWalk &one) {
  Json json = to_json(one.what);
  json["seconds"] = one.seconds;
  return json;
}

Json to_json(const Overrides &o) {
  Json json = to_json(o.what);
  json["same_values"] = o.same_values;
  json["own_values"] = o.own_values;
  json["several_media"] = o.several_media;
  return json;
}

Json to_json(const Summary &s) {
  return {{"median_ratio", s.median_ratio},
          {"least_ratio", s.least_ratio},
          {"slowdown_10k_to_600k", s.slowdown},
          {"plain_slowdown_10k_to_600k", s.plain_slowdown},
          {"worst_disagreement", s.worst_disagreement}};
}

Json to_json(const Build &b) {
  return {{"mesh", b.mesh},           {"width", b.width},
          {"triangles", b.triangles}, {"build_seconds", b.seconds},
          {"build_bytes", b.bytes},   {"bytes_per_triangle", b.bytes / b.triangles}};
}

template <class T>
Json to_json(const std::vector<T> &values) {
  Json list = Json::array();
  for (const T &value : values)
    list.push_back(to_json(value));
  return list;
}

} // namespace

void print_header(const TynDeviceInfo &device) {
  std::printf("%s, %u compute units\n"
              "each line: the library's walk | the plain walk, ratio of their speeds | escaped weight of both |\n"
              "variance of its mean times seconds of work, of both. width: mean free paths across; sc: scatterings;\n"
              "free: flights that needed no ray\n\n",
              device.name, device.compute_units);
}

void print(const Build &b) {
  std::printf("%s, width %g: %u triangles, committed in %.3f s, %.2f MB for rays, %.0f bytes a triangle\n",
              b.mesh.c_str(), double(b.width), b.triangles, b.seconds, 1e-6 * b.bytes, b.bytes / b.triangles);
  std::fflush(stdout);
}

void print_columns() {
  std::printf("\n%-11s %5s %4s %4s %6s | %9s %8s %7s %7s %6s | %9s %6s | %-18s %-18s | %8s %8s\n", "mesh", "width", "g",
              "ior", "albedo", "scatt/s", "walks/s", "sc/walk", "rays/sc", "free", "plain", "ratio", "escaped", "plain",
              "var s", "plain");
  std::fflush(stdout);
}

void print(const Result &r) {
  std::printf(
      "%-11s %5g %4g %4g %6g | %9.3g %8.3g %7.2f %7.4f %6.4f | %9.3g %6.2f | %.5f +- %.5f %.5f +- %.5f | %8.2g %8.2g\n",
      r.what.mesh.c_str(), double(r.what.width), double(r.what.g), double(r.what.ior), double(r.what.albedo),
      r.ours.scatterings_per_second(), r.ours.walks_per_second(), r.ours.scatterings_per_walk(),
      r.ours.rays_per_scattering(), r.free_flights(), r.plain.scatterings_per_second(), r.ratio(), r.ours.sums.mean(),
      r.ours.sums.standard_error(), r.plain.sums.mean(), r.plain.sums.standard_error(), r.ours.variance_seconds(),
      r.plain.variance_seconds());
  std::fflush(stdout);
}

void print_summary(const Results &results) {
  Summary s = summarize(results.cases);
  std::printf(
      "\n%zu cases: ratio to the plain walk %.2f (median), %.2f (least); escaped weights differ by at most %.1f "
      "standard errors\n",
      results.cases.size(), s.median_ratio, s.least_ratio, s.worst_disagreement);
  if (std::isfinite(s.slowdown))
    std::printf("from 1e4 to 6e5 triangles: %.2f times slower (plain: %.2f)\n", s.slowdown, s.plain_slowdown);
}

void print(const OneWalk &one) {
  const Case &c = one.what;
  std::printf("%-11s width %4g, g %3g, ior %3g, albedo %5g: one walk in %.3f ms\n", c.mesh.c_str(), double(c.width),
              double(c.g), double(c.ior), double(c.albedo), 1e3 * one.seconds);
  std::fflush(stdout);
}

void print(const Overrides &o) {
  const Case &c = o.what;
  std::printf(
      "%-11s width %4g, g %3g, ior %3g, albedo %5g: speed with the medium's values in the entries %.2f, with values of "
      "their own %.2f, with several media %.2f\n",
      c.mesh.c_str(), double(c.width), double(c.g), double(c.ior), double(c.albedo), o.same_values, o.own_values,
      o.several_media);
  std::fflush(stdout);
}

void print_json(const Results &results) {
  Json document = {{"device", results.device.name},
                   {"compute_units", results.device.compute_units},
                   {"lane_width", results.device.lane_width}};
  if (!results.one_walks.empty()) {
    document["one_walk"] = to_json(results.one_walks);
  } else if (!results.overrides.empty()) {
    document["overrides"] = to_json(results.overrides);
  } else {
    document["meshes"] = to_json(results.builds);
    document["cases"] = to_json(results.cases);
    document["summary"] = to_json(summarize(results.cases));
  }
  std::printf("%s\n", document.dump(2).c_str());
}

void warn(const Result &r) {
  if (r.disagreement() <= 4)
    return;
  std::fprintf(
      stderr,
      "warning: %s, width %g, g %g, ior %g, albedo %g: escaped %.5f +- %.5f, plainly %.5f +- %.5f, which is %.1f "
      "standard errors apart\n",
      r.what.mesh.c_str(), double(r.what.width), double(r.what.g), double(r.what.ior), double(r.what.albedo),
      r.ours.sums.mean(), r.ours.sums.standard_error(), r.plain.sums.mean(), r.plain.sums.standard_error(),
      r.disagreement());
}

} // namespace bench
