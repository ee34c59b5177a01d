// SPDX-License-Identifier: Apache-2.0
#include "report/table.h"

#include "core/html.h"
#include "report/html_table.h"
#include "study/diagnosis_format.h"
#include "study/format.h"
#include "study/judgement_format.h"

#include <fmt/format.h>

#include <algorithm>

namespace umbrameter {
namespace {

std::optional<double> value_of(const std::optional<Interval>& interval) {
  return interval ? std::optional(interval->value) : std::nullopt;
}

std::string fault_cell(const std::optional<Diagnosis>& diagnosis) {
  const auto worst = diagnosis ? worst_fault(diagnosis->faults) : std::nullopt;
  std::optional<double> part;
  if (diagnosis) part = worst ? diagnosis->faults.of(*worst).mean_abs_error : 0.0;
  return number_cell("worst_fault", part, format_worst_fault(diagnosis));
}

std::string error_cells(const VisibilityError& error) {
  const auto penumbra = region_rmse(error.penumbra);
  return number_cell("rmse", value_of(error.rmse), format_interval(error.rmse)) +
         number_cell("bias", error.bias, format_signed_error(error.bias)) +
         number_cell("over_shadowing", error.over_shadowing, format_error(error.over_shadowing)) +
         number_cell("under_shadowing", error.under_shadowing, format_error(error.under_shadowing)) +
         number_cell("penumbra_rmse", penumbra, format_error(penumbra)) +
         number_cell("penumbra_share", error.penumbra.share, format_share(error.penumbra.share));
}

std::string verdict_cell(const Judgement& judgement) {
  std::string text = judgement.verdict ? format_verdict(judgement.verdict) : "";
  if (judgement.limit) text += (text.empty() ? "limit: " : "; limit: ") + format_limit(*judgement.limit);
  return fmt::format("<td data-column=\"verdict\">{}</td>",
                     escape_html(text.empty() ? kNotApplicable : text));
}

std::string wrong_cell(const std::optional<SignificanceNumbers>& numbers) {
  if (!numbers || numbers->tested == 0) return number_cell("wrong_pixels", std::nullopt, kNotApplicable);
  const size_t wrong = numbers->too_dark + numbers->too_bright;
  return number_cell("wrong_pixels", static_cast<double>(wrong),
                     format_share(static_cast<double>(wrong) / static_cast<double>(numbers->tested)));
}

std::string missing_cells(const SceneResult& scene, const TechniqueResult& run) {
  std::string reason = "not compared";
  if (run.failure)
    reason = run.failure->message;
  else if (scene.parity && !scene.parity->passes)
    reason = "void: parity fails";
  else if (scene.failure)
    reason = scene.failure->message;
  return fmt::format("<td colspan=\"9\" class=\"problem\">{}</td>", escape_html(reason));
}

std::string row(const SceneResult& scene, size_t scene_index, size_t run_index) {
  const TechniqueResult& run = scene.techniques[run_index];
  const auto total = total_time(run.pass_times);
  const auto total_ms = total ? std::optional(total->median_ms) : std::nullopt;
  const auto memory =
      run.memory_bytes > 0 ? std::optional(static_cast<double>(run.memory_bytes)) : std::nullopt;
  return fmt::format(
             "<tr data-scene=\"{0}\" data-technique=\"{1}\"><th scope=\"row\"><a "
             "href=\"#{2}\">{0}</a></th><td><a href=\"#{3}\">{1}</a></td>",
             escape_html(scene.name), escape_html(run.label), scene_anchor(scene_index),
             run_anchor(scene_index, run_index)) +
         (run.error ? error_cells(*run.error) + fault_cell(run.diagnosis) +
                          wrong_cell(run.judgement.significance) + verdict_cell(run.judgement)
                    : missing_cells(scene, run)) +
         number_cell("total_ms", total_ms, format_time(total)) +
         number_cell("memory_bytes", memory, memory ? format_bytes(run.memory_bytes) : kNotApplicable) +
         "</tr>\n";
}

}  // namespace

std::string scene_anchor(size_t scene_index) {
  return fmt::format("scene-{}", scene_index + 1);
}

std::string run_anchor(size_t scene_index, size_t run_index) {
  return fmt::format("{}-run-{}", scene_anchor(scene_index), run_index + 1);
}

std::string format_limit(const LimitNumbers& limit) {
  std::string text(name_of(limit.outcome));
  std::ranges::replace(text, '_', ' ');
  return text;
}

std::string summary_rows(const Results& results) {
  std::string rows;
  for (size_t i = 0; i < results.scenes.size(); ++i) {
    for (size_t k = 0; k < results.scenes[i].techniques.size(); ++k) rows += row(results.scenes[i], i, k);
  }
  return rows;
}

}  // namespace umbrameter
