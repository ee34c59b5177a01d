// SPDX-License-Identifier: Apache-2.0
#include "cli/exact_check.h"

#include "reference/reference.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <sys/resource.h>

namespace umbrameter {
namespace {

/// Of the processes that this one started and that have ended.
double children_cpu_seconds() {
  rusage usage{};
  getrusage(RUSAGE_CHILDREN, &usage);
  const auto seconds = [](const timeval& t) {
    return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec);
  };
  return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

std::string describe(const CheckedPoint& point) {
  return fmt::format("pixel ({}, {}): {:.6f} where {:.6f} is true, standard error {:.6f}", point.x_px,
                     point.y_px, point.visibility, point.exact(), point.visibility_se);
}

nlohmann::json to_json(const CheckedPoint& point) {
  return {{"x_px", point.x_px},
          {"y_px", point.y_px},
          {"exact_low", point.exact_low},
          {"exact_high", point.exact_high},
          {"visibility", point.visibility},
          {"visibility_se", point.visibility_se},
          {"triangles", point.triangles}};
}

}  // namespace

ExactCheck run_exact_check(const Scene& scene, const Image& reference, const RenderRequest& request,
                           size_t count, const ExactOracle& oracle, int threads, Progress& progress) {
  // Strata from the picture under test would choose points by their errors; another seed's owe it nothing.
  RenderRequest pilot = request;
  pilot.seed = ~request.seed;
  const Frame frame = make_reference_renderer({64, {}, threads})->render(scene, pilot, progress);
  ExactCheck check;
  const std::vector<size_t> pixels = draw_check_pixels(frame.image, count, request.seed);
  const double before_s = children_cpu_seconds();
  check.points = check_pixels(scene, reference, pixels, oracle, threads, progress);
  check.cpu_time_s = children_cpu_seconds() - before_s;
  check.comparison = compare_with_exact(check.points);
  return check;
}

std::string describe(const ExactCheck& check) {
  const ExactComparison& c = check.comparison;
  const ExactAgreement& p = c.penumbra;
  std::string text =
      fmt::format("exact check: {} points in {:.1f} CPU s\n", check.points.size(), check.cpu_time_s);
  if (p.points > 0) {
    text += fmt::format(
        "  {} in the penumbra: {:.1f} % inside their 95 % interval; mean error {:+.6f} (noise {:.6f}), RMS "
        "error "
        "{:.6f} (stated {:.6f})\n",
        p.points, 100.0 * p.coverage(), p.mean_error, p.mean_error_noise, p.rms_error, p.rms_se);
  }
  text += fmt::format("  {} others: {} wrong\n", c.others, c.others_wrong);
  if (c.irradiance_rms_error)
    text += fmt::format("  irradiance ratio: RMS error {:.6f}\n", *c.irradiance_rms_error);
  if (c.worst) text += fmt::format("  worst, {}\n", describe(*c.worst));
  return text;
}

nlohmann::json to_json(const ExactCheck& check) {
  const ExactComparison& c = check.comparison;
  const ExactAgreement& p = c.penumbra;
  nlohmann::json json{{"points", check.points.size()},
                      {"cpu_time_s", check.cpu_time_s},
                      {"others", c.others},
                      {"others_wrong", c.others_wrong}};
  if (p.points > 0) {
    json["penumbra"] = {{"points", p.points},
                        {"covered", p.covered},
                        {"coverage", p.coverage()},
                        {"mean_error", p.mean_error},
                        {"mean_error_noise", p.mean_error_noise},
                        {"rms_error", p.rms_error},
                        {"rms_se", p.rms_se}};
  }
  if (c.irradiance_rms_error) json["irradiance_rms_error"] = *c.irradiance_rms_error;
  if (c.worst) json["worst"] = to_json(*c.worst);
  return json;
}

}  // namespace umbrameter
