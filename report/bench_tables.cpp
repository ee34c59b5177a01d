// SPDX-License-Identifier: Apache-2.0
#include "report/bench_tables.h"

#include "report/html_table.h"
#include "study/format.h"
#include "study/run_json.h"

#include <fmt/format.h>

namespace umbrameter {
namespace {

using Json = nlohmann::ordered_json;

std::optional<double> value_of(const std::optional<Interval>& interval) {
  return interval ? std::optional(interval->value) : std::nullopt;
}

std::string significant(const std::optional<Interval>& interval, int digits, const char* unit) {
  if (!interval) return kNotApplicable;
  return fmt::format("{:.{}g}{} [{:.{}g}, {:.{}g}]", interval->value, digits, unit, interval->low, digits,
                     interval->high, digits);
}

std::string place_text(const Json& run) {
  if (run.at("is_on_front").is_null()) return kNotApplicable;
  if (run.at("is_on_front").get<bool>()) return "on the front";
  return "behind " + run.at("dominated_by").get<std::string>();
}

std::string parameters_text(const Json& parameters) {
  std::string text;
  for (const auto& [name, value] : parameters.items()) {
    const std::string shown = value.is_string() ? value.get<std::string>() : value.dump();
    text += fmt::format("{}{}={}", text.empty() ? "" : " ", name, shown);
  }
  return text;
}

std::string run_row(const Json& run, bool is_recommended) {
  const std::string label = run.at("label").get<std::string>();
  const auto time_ms = read_interval(run.at("time_ms")), rmse = read_interval(run.at("rmse"));
  const auto memory = run.at("memory_bytes").get<uint64_t>();
  std::string place = place_text(run);
  if (is_recommended) place += ", recommended";
  if (!run.at("failure").is_null()) place = run.at("failure").at("message").get<std::string>();
  return name_cell(label) + number_cell("time_ms", value_of(time_ms), significant(time_ms, 4, " ms")) +
         number_cell("rmse", value_of(rmse), format_interval(rmse)) +
         number_cell("memory_bytes", static_cast<double>(memory), format_bytes(memory)) +
         text_cell(place, run.at("failure").is_null() ? "" : "problem") + text_cell(run.at("seed").dump()) +
         text_cell(parameters_text(run.at("parameters")), "context");
}

std::string paper_text(const Json& paper) {
  const double low = paper.at("low").get<double>();
  if (paper.at("high").is_null()) return fmt::format("at least {:.3g}", low);
  const double high = paper.at("high").get<double>();
  return low == high ? fmt::format("{:.3g}", low) : fmt::format("{:.3g} to {:.3g}", low, high);
}

/// As format_compares().
std::string compares_text(const Json& counts) {
  const auto text = [](const Json& count) {
    return count.is_null() ? "?" : fmt::format("{:.4g}", count.get<double>());
  };
  return fmt::format("{} : {}", text(counts.at(0)), text(counts.at(1)));
}

std::string claim_row(const Json& claim) {
  const auto ours = read_interval(claim.at("ours"));
  std::string verdict = claim.at("verdict").get<std::string>();
  const std::string reason = claim.at("reason").get<std::string>();
  if (!reason.empty()) verdict += ": " + reason;
  return name_cell(claim.at("text").get<std::string>()) + text_cell(claim.at("source").get<std::string>()) +
         text_cell(fmt::format("{} of {} / {}", claim.at("quantity").get<std::string>(),
                               claim.at("numerator").get<std::string>(),
                               claim.at("denominator").get<std::string>())) +
         text_cell(compares_text(claim.at("compares_per_pixel"))) +
         number_cell("paper", claim.at("paper").at("low").get<double>(), paper_text(claim.at("paper"))) +
         number_cell("ours", value_of(ours), significant(ours, 3, "")) + text_cell(verdict);
}

std::string truth_row(const Json& point) {
  const double cpu_s = point.at("cpu_s").get<double>(), rmse = point.at("rmse").get<double>();
  return name_cell(fmt::format("{} {}", point.at("kind").get<std::string>(), point.at("setting").dump())) +
         number_cell("cpu_s", cpu_s,
                     fmt::format("{:.4g} ± {:.2g} s", cpu_s, point.at("cpu_mad_s").get<double>())) +
         number_cell("rmse", rmse,
                     format_interval(Interval{rmse, point.at("rmse_low").get<double>(),
                                              point.at("rmse_high").get<double>()})) +
         number_cell("rays_per_pixel", point.at("rays_per_pixel").get<double>(),
                     fmt::format("{:.4g}", point.at("rays_per_pixel").get<double>()));
}

template <class Row>
std::vector<std::string> rows_of(const Json& list, const Row& row) {
  std::vector<std::string> rows;
  for (const Json& item : list) rows.push_back(row(item));
  return rows;
}

}  // namespace

std::string bench_runs_table(const Json& scene) {
  const Json& best = scene.at("recommended");
  return scroll_table(
      "Time and error of every run",
      {{"Run"},
       {"Time of a frame [95 %]", true},
       {"RMSE [95 %]", true},
       {"Memory", true},
       {"Front"},
       {"Seed"},
       {"Parameters"}},
      rows_of(scene.at("runs"), [&](const Json& run) { return run_row(run, run.at("label") == best); }));
}

std::string bench_claims_table(const Json& scene) {
  if (scene.at("claims").empty()) return {};
  return "<h4>What papers claim</h4>\n" + scroll_table("What papers claim, and what was measured",
                                                       {{"Claim"},
                                                        {"Source"},
                                                        {"Ratio"},
                                                        {"Compares a pixel"},
                                                        {"Paper", true},
                                                        {"Ours [95 %]", true},
                                                        {"Verdict"}},
                                                       rows_of(scene.at("claims"), claim_row));
}

std::string bench_truth_table(const Json& scene) {
  if (!scene.contains("truth") || scene.at("truth").is_null()) return {};
  return "<h4>The truth's own time against error</h4>\n" +
         scroll_table("The truth's time against error",
                      {{"Setting"}, {"Processor time", true}, {"RMSE [95 %]", true}, {"Rays a pixel", true}},
                      rows_of(scene.at("truth").at("points"), truth_row));
}

}  // namespace umbrameter
