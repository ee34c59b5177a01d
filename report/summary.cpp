// SPDX-License-Identifier: Apache-2.0
#include "report/summary.h"

#include "results/format.h"
#include "results/judgement_format.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>

namespace umbrameter {
namespace {

using OrderedJson = nlohmann::ordered_json;

std::string counted(const std::map<std::string, size_t>& counts) {
  std::string text;
  for (const auto& [what, count] : counts)
    text += fmt::format("{}{} {}", text.empty() ? "" : ", ", count, what);
  return text;
}

/// "2 scenes, 4 runs, 4 scored. Limit: pass 3, fail 1.": limits and verdicts of all runs, each only where there are any.
std::string verdict_counts(const Results& results) {
  std::map<std::string, size_t> limits, verdicts;
  size_t runs = 0, scored = 0;
  for (const SceneResult& scene : results.scenes) {
    for (const TechniqueResult& run : scene.techniques) {
      ++runs;
      scored += run.error ? 1 : 0;
      if (run.judgement.limit) ++limits[std::string(name_of(run.judgement.limit->outcome))];
      if (run.judgement.verdict) ++verdicts[format_verdict(run.judgement.verdict)];
    }
  }
  std::string text = fmt::format("{} scene{}, {} run{}, {} scored.", results.scenes.size(),
                                 results.scenes.size() == 1 ? "" : "s", runs, runs == 1 ? "" : "s", scored);
  if (!limits.empty()) text += " Limit: " + counted(limits) + ".";
  if (!verdicts.empty()) text += " Against the baseline: " + counted(verdicts) + ".";
  return text;
}

bool has_scored_run(const SceneResult& scene) {
  return std::ranges::any_of(scene.techniques,
                             [](const TechniqueResult& run) { return run.error.has_value(); });
}

/// What keeps a scene from having numbers; empty where it has them (the overview shows those).
std::string scene_problem(const SceneResult& scene) {
  if (scene.failure) return "failed";
  if (scene.parity && !scene.parity->passes) return "void: the two renderers disagree";
  return has_scored_run(scene) ? "" : "nothing compared";
}

}  // namespace

OrderedJson summary_verdicts(const Results& results) {
  OrderedJson problems = OrderedJson::array(), scenes = OrderedJson::array();
  for (const Failure& failure : all_failures(results)) problems.push_back("Failed: " + failure.message);
  if (!parity_passes(results))
    problems.push_back("The two renderers disagree on at least one scene; its numbers are void.");
  if (exceeds_limit(results)) problems.push_back("At least one technique exceeds the limit.");
  for (const SceneResult& scene : results.scenes) scenes.push_back(scene_problem(scene));
  return {{"problems", problems}, {"counts", verdict_counts(results)}, {"scenes", scenes}};
}

}  // namespace umbrameter
