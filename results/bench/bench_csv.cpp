// SPDX-License-Identifier: Apache-2.0
#include "results/bench/bench_json.h"
#include "results/csv.h"
#include "results/metadata.h"

#include <fmt/format.h>

namespace umbrameter {
namespace {

std::string pass_text(const std::vector<PassTime>& times) {
  std::string text;
  for (const PassTime& time : times) {
    if (time.pass == "total") continue;
    text += fmt::format("{}{}={}", text.empty() ? "" : "; ", time.pass, csv_number(time.median_ms));
  }
  return text;
}

std::string front_text(const BenchEntry& entry) {
  if (!entry.has_place) return "unknown";
  return entry.dominated_by ? "dominated by " + *entry.dominated_by : "front";
}

std::string device_kind(const BenchEntry& entry) {
  if (entry.device.empty()) return "";
  return entry.is_software ? kSoftwareNote : "hardware";
}

std::vector<std::string> cells(const BenchScene& scene, const BenchEntry& entry,
                               const BenchResults& results) {
  const std::vector<PassTime> times = summarise(entry.times);
  const auto total = total_time(times);
  std::vector<std::string> row{scene.name,
                               scene.hash,
                               entry.label,
                               entry.technique,
                               to_text(entry.parameters),
                               std::to_string(entry.seed),
                               std::to_string(results.plan.picture.width_px),
                               std::to_string(results.plan.picture.height_px)};
  add_interval(entry.rmse(), row);
  row.push_back(entry.error && entry.error->bias ? csv_number(*entry.error->bias) : "");
  row.push_back(total ? csv_number(total->median_ms) : "");
  row.push_back(entry.time_ms ? csv_number(entry.time_ms->low) : "");
  row.push_back(entry.time_ms ? csv_number(entry.time_ms->high) : "");
  row.push_back(total ? csv_number(total->mad_ms) : "");
  row.push_back(total ? std::to_string(total->frames) : "0");
  row.push_back(pass_text(times));
  row.push_back(std::to_string(entry.memory_bytes));
  row.push_back(front_text(entry));
  row.push_back(entry.timer);
  row.push_back(entry.device);
  row.push_back(device_kind(entry));
  row.push_back(results.commit);
  row.push_back(entry.failure ? entry.failure->message : "");
  return row;
}

}  // namespace

std::string to_csv(const BenchResults& results) {
  std::string text =
      csv_line({"scene",     "scene_hash",  "label",    "technique", "parameters",   "seed",    "width_px",
                "height_px", "rmse",        "rmse_low", "rmse_high", "bias",         "time_ms", "time_low",
                "time_high", "time_mad",    "frames",   "pass_ms",   "memory_bytes", "front",   "timer",
                "device",    "device_kind", "commit",   "failure"});
  for (const BenchScene& scene : results.scenes) {
    for (const BenchEntry& entry : scene.entries) text += csv_line(cells(scene, entry, results));
  }
  return text;
}

std::string truth_csv(const BenchResults& results) {
  std::string text = csv_line({"scene", "kind", "setting", "cpu_s", "cpu_mad_s", "rays_per_pixel", "rmse",
                               "rmse_low", "rmse_high", "exponent"});
  for (const BenchScene& scene : results.scenes) {
    if (!scene.truth) continue;
    for (const TruthPoint& point : scene.truth->points) {
      std::vector<std::string> row{scene.name,
                                   point.kind,
                                   csv_number(point.setting),
                                   csv_number(point.cpu_s.median),
                                   csv_number(point.cpu_s.mad),
                                   csv_number(point.rays_per_pixel)};
      add_interval(point.rmse, row);
      row.push_back(scene.truth->exponent ? csv_number(*scene.truth->exponent) : "");
      text += csv_line(row);
    }
  }
  return text;
}

}  // namespace umbrameter
