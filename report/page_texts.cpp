// SPDX-License-Identifier: Apache-2.0
#include "report/page_texts.h"

#include "report/facts.h"
#include "report/plane_code.h"
#include "report/summary.h"
#include "report/table.h"
#include "results/format.h"

#include <fmt/format.h>

#include <set>

namespace umbrameter {
namespace {

using OrderedJson = nlohmann::ordered_json;

std::string devices(const Results& results) {
  std::set<std::string> names;
  for (const SceneResult& scene : results.scenes) {
    if (scene.reference) names.insert(scene.reference->device);
    for (const TechniqueResult& run : scene.techniques) {
      if (run.device.empty()) continue;
      names.insert(run.timer.empty() ? run.device : run.device + ", timed by " + run.timer);
    }
  }
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "" : "; ") + name;
  return text;
}

std::string context(const Results& results) {
  const std::string target =
      results.picture.target_se ? fmt::format(", until standard error {}", *results.picture.target_se) : "";
  const std::string quality = results.quality.empty() ? "" : fmt::format("quality {}, ", results.quality);
  return fmt::format("umbrameter {} ({}); {}{} x {} px, {} samples per pixel{}, seed {}; {}", results.version,
                     results.commit, quality, results.picture.width_px, results.picture.height_px,
                     results.picture.samples_per_pixel, target, results.picture.seed, devices(results));
}

std::string pixel_steps() {
  return fmt::format(
      "Pixels inside this page: V in steps of 1/{:.0f}, R of 1/{:.0f}, standard error and blocker distance "
      "as half "
      "floats (11 bits), positions in 65535 steps over their range. Read-outs, maps, profiles and z are of "
      "these; every "
      "other number is that of results.json.",
      1.0 / kTestVisibilityCode.step, 1.0 / kReferenceVisibilityCode.step);
}

OrderedJson scene_texts(const Results& results, const SceneResult& scene) {
  const TermLines common{
      {"scene hash", scene.hash},
      {"seed", std::to_string(results.picture.seed)},
      {"resolution", fmt::format("{} x {} px", results.picture.width_px, results.picture.height_px)},
      {"version", fmt::format("umbrameter {} ({})", results.version, results.commit)}};
  OrderedJson runs = OrderedJson::array();
  for (const TechniqueResult& run : scene.techniques) runs.push_back(run_facts(run));
  return {{"parity", scene.parity ? OrderedJson(format_parity(*scene.parity)) : OrderedJson(nullptr)},
          {"common", common},
          {"reference", scene.reference ? OrderedJson(reference_facts(scene)) : OrderedJson(nullptr)},
          {"rows", summary_rows(scene)},
          {"runs", runs}};
}

}  // namespace

OrderedJson page_texts(const Results& results) {
  OrderedJson scenes = OrderedJson::array(), skipped = OrderedJson::array();
  for (const SceneResult& scene : results.scenes) scenes.push_back(scene_texts(results, scene));
  for (const Skip& skip : results.skipped) {
    skipped.push_back(fmt::format("{}{}{}: {}", skip.scene, skip.technique.empty() ? "" : ", ",
                                  skip.technique, skip.reason));
  }
  return {{"context", context(results)},
          {"summary", summary_verdicts(results)},
          {"scenes", scenes},
          {"skipped", skipped},
          {"pixel_steps", pixel_steps()}};
}

}  // namespace umbrameter
