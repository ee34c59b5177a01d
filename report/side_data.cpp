// SPDX-License-Identifier: Apache-2.0
#include "report/side_data.h"

#include "core/error.h"
#include "report/required_fields.h"
#include "report/side_files.h"
#include "study/stress/summary.h"

#include <fmt/format.h>

#include <array>

namespace umbrameter {
namespace {

using OrderedJson = nlohmann::ordered_json;
using std::string_view;

constexpr std::array kBenchFields = std::to_array<string_view>({"title:text",
                                                                "doc:text",
                                                                "study:text",
                                                                "version:text",
                                                                "commit:text",
                                                                "width_px:number",
                                                                "height_px:number",
                                                                "samples_per_pixel:number",
                                                                "wanted_frames:number",
                                                                "note:text",
                                                                "recommended?.label:text",
                                                                "recommended?.cost:number",
                                                                "recommended?.scenes:number",
                                                                "scenes[].name:text",
                                                                "scenes[].title:text",
                                                                "scenes[].triangles:number",
                                                                "scenes[].light:text",
                                                                "scenes[].hash:text",
                                                                "scenes[].reference_device:text",
                                                                "scenes[].failure?.message:text",
                                                                "scenes[].warnings[]:text",
                                                                "scenes[].recommended?:text",
                                                                "scenes[].runs[].label:text",
                                                                "scenes[].runs[].time_ms?.value:number",
                                                                "scenes[].runs[].time_ms?.low:number",
                                                                "scenes[].runs[].time_ms?.high:number",
                                                                "scenes[].runs[].error?.rmse?.value:number",
                                                                "scenes[].runs[].error?.rmse?.low:number",
                                                                "scenes[].runs[].error?.rmse?.high:number",
                                                                "scenes[].runs[].memory_bytes:number",
                                                                "scenes[].runs[].is_on_front?:flag",
                                                                "scenes[].runs[].failure?.message:text",
                                                                "scenes[].runs[].seed:number",
                                                                "scenes[].runs[].parameters:object",
                                                                "scenes[].claims[].text:text",
                                                                "scenes[].claims[].source:text",
                                                                "scenes[].claims[].quantity:text",
                                                                "scenes[].claims[].numerator:text",
                                                                "scenes[].claims[].denominator:text",
                                                                "scenes[].claims[].paper.low:number",
                                                                "scenes[].claims[].paper.high?:number",
                                                                "scenes[].claims[].ours?.value:number",
                                                                "scenes[].claims[].verdict:text",
                                                                "scenes[].claims[].reason:text"});

constexpr std::array kTruthFields = std::to_array<string_view>(
    {"points[].kind:text", "points[].setting:number", "points[].cpu_s:number", "points[].cpu_mad_s:number",
     "points[].rays_per_pixel:number", "points[].rmse:number", "points[].rmse_low:number",
     "points[].rmse_high:number"});

constexpr std::array kRegressFields = std::to_array<string_view>({"suite:text",
                                                                  "passes:flag",
                                                                  "pass:number",
                                                                  "better:number",
                                                                  "undecided:number",
                                                                  "fail:number",
                                                                  "width_px:number",
                                                                  "height_px:number",
                                                                  "seed:number",
                                                                  "cases[].scene:text",
                                                                  "cases[].label:text",
                                                                  "cases[].outcome:text",
                                                                  "cases[].kind:text",
                                                                  "cases[].message:text",
                                                                  "cases[].notes[]:text",
                                                                  "cases[].samples_per_pixel:number",
                                                                  "cases[].added_samples_per_pixel:number",
                                                                  "cases[].pictures:number",
                                                                  "cases[].before?.rmse?.value:number",
                                                                  "cases[].now?.rmse?.value:number",
                                                                  "cases[].gate[].class:text",
                                                                  "cases[].gate[].baseline?:number",
                                                                  "cases[].gate[].value?:number",
                                                                  "cases[].gate[].allowed?:number",
                                                                  "cases[].gate[].severity?:number"});

constexpr std::array kStressFields = std::to_array<string_view>({"title:text",
                                                                 "version:text",
                                                                 "commit:text",
                                                                 "device:text",
                                                                 "width_px:number",
                                                                 "height_px:number",
                                                                 "samples_per_pixel:number",
                                                                 "seed:number",
                                                                 "violations[]:text",
                                                                 "rows[]:text",
                                                                 "axes[].name:text",
                                                                 "axes[].unit:text",
                                                                 "axes[].doc:text",
                                                                 "axes[].nominal:number",
                                                                 "axes[].values[]:text",
                                                                 "ranges[].row:text",
                                                                 "ranges[].axis:text",
                                                                 "ranges[].applies:flag",
                                                                 "cells[].axis:text",
                                                                 "cells[].row:text",
                                                                 "cells[].value:number",
                                                                 "cells[].rmse?.value:number"});

constexpr std::array kRangeFields =
    std::to_array<string_view>({"first:text", "last:text", "held:number", "values:number",
                                "break_before?.value:text", "break_after?.value:text"});

constexpr std::array kNoRangeFields = std::to_array<string_view>({"why_not:text"});

/// What a person calls it: "leak", "wrong width", "refused".
void add_words(OrderedJson& cell) {
  const std::string name = text_of(cell, "outcome"), how = text_of(cell, "how");
  for (size_t k = 0; k < kStressOutcomes; ++k) {
    const auto outcome = static_cast<StressOutcome>(k);
    if (name_of(outcome) != name) continue;
    cell["words"] = words_for(outcome, how);
    return;
  }
  fail_input(fmt::format("no outcome of a stress run is called '{}'", name));
}

void add_range_words(OrderedJson& range) {
  if (!range.at("applies").get<bool>()) return require_fields(range, kNoRangeFields);
  require_fields(range, kRangeFields);
  for (const char* end : {"break_before", "break_after"}) {
    if (!range.at(end).is_null()) add_words(range.at(end));
  }
}

/// What the page shows of a run.
OrderedJson shown_run(const OrderedJson& run) {
  OrderedJson shown{{"rmse", run.at("error").is_null() ? OrderedJson(nullptr) : run.at("error").at("rmse")}};
  for (const char* key : {"label", "time_ms", "pass_times", "memory_bytes", "is_on_front", "dominated_by",
                          "failure", "seed", "parameters"})
    shown[key] = run.at(key);
  return shown;
}

OrderedJson bench_data(const std::filesystem::path& folder) {
  OrderedJson studies = OrderedJson::array();
  for_side_files(folder, kBenchSchema, [&](const OrderedJson& document, const std::string& file) {
    const OrderedJson list =
        document.contains("studies") ? document.at("studies") : OrderedJson::array({document});
    for (OrderedJson study : list) {
      require_fields(study, kBenchFields);
      for (OrderedJson& scene : study.at("scenes")) {
        for (OrderedJson& run : scene.at("runs")) run = shown_run(run);
        if (scene.contains("truth") && !scene.at("truth").is_null())
          require_fields(scene.at("truth"), kTruthFields);
      }
      study["file"] = file;
      studies.push_back(std::move(study));
    }
  });
  return studies;
}

OrderedJson stress_data(const std::filesystem::path& folder) {
  OrderedJson maps = OrderedJson::array();
  for_side_files(folder, kStressSchema, [&](const OrderedJson& document, const std::string& file) {
    require_fields(document, kStressFields);
    OrderedJson map = document;
    map["file"] = file;
    for (OrderedJson& cell : map["cells"]) add_words(cell);
    for (OrderedJson& range : map["ranges"]) add_range_words(range);
    maps.push_back(std::move(map));
  });
  return maps;
}

OrderedJson regress_data(const std::filesystem::path& folder) {
  OrderedJson checks = OrderedJson::array();
  for_side_files(folder, kRegressSchema, [&](const OrderedJson& document, const std::string& file) {
    require_fields(document, kRegressFields);
    OrderedJson check = document;
    check["file"] = file;
    checks.push_back(std::move(check));
  });
  return checks;
}

}  // namespace

OrderedJson side_data(const std::filesystem::path& folder) {
  return {{"benches", bench_data(folder)},
          {"stresses", stress_data(folder)},
          {"regressions", regress_data(folder)}};
}

}  // namespace umbrameter
