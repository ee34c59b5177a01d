// SPDX-License-Identifier: Apache-2.0
#include "report/table.h"

#include "results/diagnosis_format.h"
#include "results/format.h"
#include "results/judgement_format.h"

#include <fmt/format.h>

#include <algorithm>

namespace umbrameter {
namespace {

using OrderedJson = nlohmann::ordered_json;

std::optional<double> value_of(const std::optional<Interval>& interval) {
  return interval ? std::optional(interval->value) : std::nullopt;
}

/// A column's full-precision value, which sorts, and its text.
OrderedJson cell(const std::optional<double>& value, const std::string& text) {
  return {value ? OrderedJson(*value) : OrderedJson(nullptr), text};
}

OrderedJson fault_cell(const std::optional<Diagnosis>& diagnosis) {
  const auto worst = diagnosis ? worst_fault(diagnosis->faults) : std::nullopt;
  std::optional<double> part;
  if (diagnosis) part = worst ? diagnosis->faults.of(*worst).mean_abs_error : 0.0;
  return cell(part, format_worst_fault(diagnosis));
}

std::string format_limit(const LimitNumbers& limit) {
  std::string text(name_of(limit.outcome));
  std::ranges::replace(text, '_', ' ');
  return text;
}

std::string verdict_text(const Judgement& judgement) {
  std::string text = judgement.verdict ? format_verdict(judgement.verdict) : "";
  if (judgement.limit) text += (text.empty() ? "limit: " : "; limit: ") + format_limit(*judgement.limit);
  return text.empty() ? kNotApplicable : text;
}

OrderedJson wrong_cell(const std::optional<SignificanceNumbers>& numbers) {
  if (!numbers || numbers->tested == 0) return cell(std::nullopt, kNotApplicable);
  const size_t wrong = numbers->too_dark + numbers->too_bright;
  return cell(static_cast<double>(wrong),
              format_share(static_cast<double>(wrong) / static_cast<double>(numbers->tested)));
}

std::string why_missing(const SceneResult& scene, const TechniqueResult& run) {
  if (run.failure) return run.failure->message;
  if (scene.parity && !scene.parity->passes) return "void: parity fails";
  return scene.failure ? scene.failure->message : "not compared";
}

void add_error_cells(OrderedJson& row, const TechniqueResult& run) {
  const VisibilityError& error = *run.error;
  const auto penumbra = region_rmse(error.penumbra);
  row["rmse"] = cell(value_of(error.rmse), format_interval(error.rmse));
  row["penumbra_rmse"] = cell(penumbra, format_error(penumbra));
  row["worst_fault"] = fault_cell(run.diagnosis);
  row["verdict"] = verdict_text(run.judgement);
  row["wrong_pixels"] = wrong_cell(run.judgement.significance);
  row["bias"] = cell(error.bias, format_signed_error(error.bias));
  row["over_shadowing"] = cell(error.over_shadowing, format_error(error.over_shadowing));
  row["under_shadowing"] = cell(error.under_shadowing, format_error(error.under_shadowing));
  row["penumbra_share"] = cell(error.penumbra.share, format_share(error.penumbra.share));
}

OrderedJson row_of(const SceneResult& scene, const TechniqueResult& run) {
  const auto total = total_time(run.pass_times);
  const auto memory =
      run.memory_bytes > 0 ? std::optional(static_cast<double>(run.memory_bytes)) : std::nullopt;
  OrderedJson row{
      {"total_ms", cell(total ? std::optional(total->median_ms) : std::nullopt, format_time(total))},
      {"memory_bytes", cell(memory, memory ? format_bytes(run.memory_bytes) : kNotApplicable)}};
  if (run.error)
    add_error_cells(row, run);
  else
    row["missing"] = why_missing(scene, run);
  return row;
}

}  // namespace

OrderedJson summary_rows(const SceneResult& scene) {
  OrderedJson rows = OrderedJson::array();
  for (const TechniqueResult& run : scene.techniques) rows.push_back(row_of(scene, run));
  return rows;
}

}  // namespace umbrameter
