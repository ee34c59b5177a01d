// SPDX-License-Identifier: Apache-2.0
#include "results/json/export.h"

#include "results/catalogue.h"
#include "results/csv.h"
#include "results/json/json_parts.h"
#include "results/json/schemas.h"
#include "results/metadata.h"

#include <set>

namespace umbrameter {
namespace {

using OrderedJson = nlohmann::ordered_json;

std::string number_text(const std::optional<double>& value) {
  return value ? csv_number(*value) : "";
}

/// Every row of the catalogue, those with an interval in three columns.
std::vector<std::string> metric_names() {
  std::vector<std::string> names;
  for (const Metric& metric : metric_catalogue()) {
    names.push_back(metric.key);
    if (metric.interval_of) names.insert(names.end(), {metric.key + "_low", metric.key + "_high"});
  }
  return names;
}

void add_metrics(const TechniqueResult& result, std::vector<std::string>& cells) {
  for (const Metric& metric : metric_catalogue()) {
    if (metric.interval_of)
      add_interval(metric.interval_of(result), cells);
    else
      cells.push_back(number_text(metric.of(result)));
  }
}

void add_times(const RunRecord& record, std::vector<std::string>& cells) {
  const auto time = total_time(record.result.pass_times), beside = total_time(record.baseline_times);
  cells.push_back(time ? csv_number(time->mad_ms) : "");
  cells.push_back(time ? std::to_string(time->frames) : "");
  cells.push_back(beside ? csv_number(beside->median_ms) : "");
  cells.push_back(record.result.timer);
}

void add_verdict(const std::optional<RunVerdict>& verdict, std::vector<std::string>& cells) {
  cells.push_back(verdict ? verdict->baseline : "");
  cells.push_back(verdict ? std::string(name_of(verdict->outcome)) : "");
  add_interval(verdict ? std::optional(verdict->mse_difference) : std::nullopt, cells);
}

std::vector<std::string> cells_of(const RunRecord& record, const std::set<std::string>& parameters) {
  const RecordHead& head = record.head;
  const TechniqueResult& result = record.result;
  std::vector<std::string> cells{head.scene,
                                 head.camera,
                                 head.scene_hash,
                                 head.light,
                                 result.label,
                                 result.technique,
                                 std::to_string(head.picture.seed),
                                 std::to_string(head.picture.width_px),
                                 std::to_string(head.picture.height_px),
                                 std::to_string(head.picture.samples_per_pixel),
                                 number_text(head.picture.target_se),
                                 status_of(record)};
  add_metrics(result, cells);
  add_times(record, cells);
  add_verdict(result.judgement.verdict, cells);
  cells.insert(cells.end(), {head.started, csv_number(head.duration_s), head.commit, result.device,
                             result.image_file, result.failure ? result.failure->message : ""});
  for (const std::string& name : parameters) {
    const auto found = result.parameters.find(name);
    cells.push_back(found == result.parameters.end() ? "" : to_text(found->second));
  }
  return cells;
}

}  // namespace

std::string to_json_text(const StoredRuns& runs) {
  OrderedJson list = OrderedJson::array();
  for (const RunRecord& run : runs.runs) list.push_back(OrderedJson::parse(to_json_text(run)));
  return dump({{"schema", kExportSchema}, {"older", runs.older}, {"foreign", runs.foreign}, {"runs", list}});
}

std::string to_csv(const StoredRuns& runs) {
  std::set<std::string> parameters;
  for (const RunRecord& run : runs.runs) {
    for (const auto& [name, value] : run.result.parameters) parameters.insert(name);
  }
  std::vector<std::string> names{"scene",     "camera", "scene_hash", "light",     "label",
                                 "technique", "seed",   "width_px",   "height_px", "samples_per_pixel",
                                 "target_se", "status"};
  const std::vector<std::string> metrics = metric_names();
  names.insert(names.end(), metrics.begin(), metrics.end());
  names.insert(names.end(), {"time_mad_ms", "frames", "baseline_ms", "timer", "baseline", "verdict",
                             "mse_difference", "mse_difference_low", "mse_difference_high", "started",
                             "duration_s", "commit", "device", "image", "failure"});
  for (const std::string& name : parameters) names.push_back("parameter." + name);
  std::string text = csv_line(names);
  for (const RunRecord& run : runs.runs) text += csv_line(cells_of(run, parameters));
  return text;
}

}  // namespace umbrameter
