// SPDX-License-Identifier: Apache-2.0
#include "results/regress/update.h"

#include "core/error.h"

#include <fmt/format.h>

#include <algorithm>

namespace umbrameter {
namespace {

bool is_void(const RegressCase& one) {
  return !one.now.has_value();
}

const RegressCase* find_case(const RegressResults& results, const RegressCase& wanted) {
  const auto found = std::ranges::find_if(results.cases, [&](const RegressCase& one) {
    return one.scene == wanted.scene && one.label == wanted.label;
  });
  return found == results.cases.end() ? nullptr : &*found;
}

BaselineScene& scene_of(Baseline& baseline, const RegressResults& measured, const std::string& name) {
  const auto found = std::ranges::find(baseline.scenes, name, &BaselineScene::name);
  const auto scene = std::ranges::find(measured.scenes, name, &RegressScene::name);
  UMBRAMETER_ASSERT(scene != measured.scenes.end(), "scene '{}' was not measured", name);
  if (found == baseline.scenes.end())
    return baseline.scenes.emplace_back(BaselineScene{scene->name, scene->hash, scene->truth, {}});
  found->hash = scene->hash;
  found->truth = scene->truth;
  return *found;
}

void drop(Baseline& baseline, const RegressCase& stale) {
  for (BaselineScene& scene : baseline.scenes) {
    if (scene.name == stale.scene)
      std::erase_if(scene.runs, [&](const BaselineRun& run) { return run.label == stale.label; });
  }
  std::erase_if(baseline.scenes, [](const BaselineScene& scene) { return scene.runs.empty(); });
}

}  // namespace

Baseline baseline_of(const RegressResults& measured, const BaselineReason& reason) {
  Baseline baseline = {measured.suite, measured.width_px, measured.height_px, {reason}, {}};
  for (const RegressCase& one : measured.cases) {
    if (!is_void(one)) put_run(scene_of(baseline, measured, one.scene), *one.now);
  }
  return baseline;
}

Baseline updated(const Baseline& baseline, const RegressResults& checked, const RegressResults& measured,
                 BaselineReason reason) {
  Baseline out = baseline;
  for (const RegressCase& one : checked.cases) {
    if (!one.has_changed()) continue;
    if (one.verdict.kind == "stale") {
      drop(out, one);
    } else if (one.label == kTruthLabel) {
      scene_of(out, measured, one.scene);
    } else {
      const RegressCase* fresh = find_case(measured, one);
      if (fresh == nullptr || is_void(*fresh)) continue;
      put_run(scene_of(out, measured, one.scene), *fresh->now);
    }
    reason.changed.push_back(one.scene + ", " + one.label);
  }
  if (!reason.changed.empty()) out.reasons.push_back(std::move(reason));
  return out;
}

}  // namespace umbrameter
