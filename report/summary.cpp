// SPDX-License-Identifier: Apache-2.0
#include "report/summary.h"

#include "core/html.h"
#include "report/table.h"
#include "study/format.h"
#include "study/judgement_format.h"

#include <fmt/format.h>

#include <algorithm>
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
  std::string html = fmt::format("<p>{} scene{}, {} run{}, {} scored.", results.scenes.size(),
                                 results.scenes.size() == 1 ? "" : "s", runs, runs == 1 ? "" : "s", scored);
  if (!limits.empty()) html += " Limit: " + counted(limits) + ".";
  if (!verdicts.empty()) html += " Against the baseline: " + counted(verdicts) + ".";
  return html + "</p>\n";
}

bool has_scored_run(const SceneResult& scene) {
  return std::ranges::any_of(scene.techniques,
                             [](const TechniqueResult& run) { return run.error.has_value(); });
}

/// What keeps a scene from having numbers; empty where it has them (the overview shows those).
std::string scene_problem(const SceneResult& scene, size_t index) {
  const std::string problem = scene.failure                           ? "failed"
                              : scene.parity && !scene.parity->passes ? "void: the two renderers disagree"
                              : !has_scored_run(scene)                ? "nothing compared"
                                                                      : "";
  if (problem.empty()) return {};
  return fmt::format("<li><a href=\"#{}\">{}</a>: {}</li>\n", scene_anchor(index), escape_html(scene.name),
                     problem);
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
  for (size_t i = 0; i < results.scenes.size(); ++i) html += scene_problem(results.scenes[i], i);
  return html + "</ul>\n";
}

}  // namespace umbrameter
