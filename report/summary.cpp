// SPDX-License-Identifier: Apache-2.0
#include "report/summary.h"

#include "core/html.h"
#include "report/table.h"
#include "study/diagnosis_format.h"
#include "study/format.h"
#include "study/judgement_format.h"

#include <fmt/format.h>

#include <map>

namespace umbrameter {
namespace {

std::string counted(const std::map<std::string, size_t>& counts) {
  std::string text;
  for (const auto& [what, count] : counts)
    text += fmt::format("{}{} {}", text.empty() ? "" : ", ", count, what);
  return text;
}

/// "pass 3, fail 1": limits and verdicts of all runs, each only where there are any.
std::string verdict_counts(const Results& results) {
  std::map<std::string, size_t> limits, verdicts;
  size_t runs = 0, scored = 0;
  for (const SceneResult& scene : results.scenes) {
    for (const TechniqueResult& run : scene.techniques) {
      ++runs;
      scored += run.error ? 1 : 0;
      if (run.judgement.limit) ++limits[format_limit(*run.judgement.limit)];
      if (run.judgement.verdict) ++verdicts[format_verdict(run.judgement.verdict)];
    }
  }
  std::string html = fmt::format("<p>{} scenes, {} runs, {} scored.", results.scenes.size(), runs, scored);
  if (!limits.empty()) html += " Limit: " + counted(limits) + ".";
  if (!verdicts.empty()) html += " Against the baseline: " + counted(verdicts) + ".";
  return html + "</p>\n";
}

const TechniqueResult* closest(const SceneResult& scene) {
  const TechniqueResult* best = nullptr;
  for (const TechniqueResult& run : scene.techniques) {
    if (!run.error || !run.error->rmse) continue;
    if (best == nullptr || run.error->rmse->value < best->error->rmse->value) best = &run;
  }
  return best;
}

std::string scene_line(const SceneResult& scene, size_t index) {
  const TechniqueResult* best = closest(scene);
  const std::string verdict =
      scene.failure                           ? "failed"
      : scene.parity && !scene.parity->passes ? "void: the two renderers disagree"
      : best == nullptr
          ? "nothing compared"
          : fmt::format("closest to the truth: {}, RMSE {}, worst fault {}", best->label,
                        format_interval(best->error->rmse), format_worst_fault(best->diagnosis));
  return fmt::format("<li><a href=\"#{}\">{}</a>: {}</li>\n", scene_anchor(index), escape_html(scene.name),
                     escape_html(verdict));
}

}  // namespace

std::string summary_verdicts(const Results& results) {
  std::string html;
  for (const Failure& failure : all_failures(results)) {
    html += fmt::format("<p class=\"problem\">Failed: {}</p>", escape_html(failure.message));
  }
  if (!parity_passes(results)) {
    html +=
        "<p class=\"problem\">The two renderers disagree on at least one scene; its numbers are void.</p>";
  }
  if (exceeds_limit(results)) html += "<p class=\"problem\">At least one technique exceeds the limit.</p>";
  html += verdict_counts(results) + "<ul class=\"scenes\">";
  for (size_t i = 0; i < results.scenes.size(); ++i) html += scene_line(results.scenes[i], i);
  return html + "</ul>\n";
}

}  // namespace umbrameter
