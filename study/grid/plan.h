// SPDX-License-Identifier: Apache-2.0
#pragma once
// What a sweep will do, said before it does it. Not here: doing it (study/grid/sweep.h).

#include "lab/keys.h"
#include "store/store.h"
#include "study/grid/bench.h"

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace umbrameter {

/// Part `index` (from 0) of `count`. Pairs of scene and run stand in line by scene; a part is an unbroken piece of that
/// line, so that few truths are needed by two parts.
struct Shard {
  size_t index = 0;
  size_t count = 1;
};

/// "2/4". Error{input} for anything else.
Shard parse_shard(const std::string& text);

struct SweepPlan {
  std::vector<BenchRun> runs;
  PictureQuality picture;
  MetricChoice metrics;
  Makers makers;
  Shard shard;
  bool reuse = true;                 // what is stored
  std::optional<TimingPlan> timing;  // absent: frames are not timed
};

/// The scene's first run of the same seed, which `run` is compared with; itself when it is that.
size_t baseline_of(const SweepPlan& plan, const Scene& scene, size_t run);

enum class StepAction { render, reuse, skip };
std::string_view to_text(StepAction action);

/// One truth or one run of a scene.
struct PlanStep {
  StepAction action = StepAction::render;
  size_t scene = 0;           // index
  std::optional<size_t> run;  // index; absent: the scene's truth
  std::string key;
  std::string reason;
  double estimated_s = 0.0;  // 0 unless it is rendered
  double saved_s = 0.0;      // 0 if it is rendered
  size_t like = 0;           // stored results that the seconds are the median of; 0 = a rough model
};

/// By scene; its truth, then its runs, of the plan's part alone. A store may be null. Failures that lie in the input are
/// reused like results, others are tried again.
std::vector<PlanStep> plan_sweep(const SweepPlan& plan, std::span<const StudyScene> scenes, Store* store);

}  // namespace umbrameter
