// SPDX-License-Identifier: Apache-2.0
#pragma once
// Renders what a suite names and judges it against a baseline, or makes one. Sees only Renderer&.

#include "lab/answers.h"
#include "lab/keys.h"
#include "study/metric_probe.h"
#include "study/regress/baseline.h"
#include "study/regress/judge.h"

#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace umbrameter {

struct RegressRenderers {
  Renderer& realtime;
  /// A reference with so many samples per pixel.
  std::function<std::shared_ptr<Renderer>(int samples_per_pixel)> make_reference;
  Makers makers = {};          // of what is kept
  Answers* answers = nullptr;  // where numbers are kept; null: nowhere
};

struct RegressPlan {
  std::string suite;
  PictureQuality picture;          // without a target
  int most_samples_per_pixel = 0;  // of a case that is not clear, and of baselines
  int timed_frames = 0;            // 0 without a gate on time
  double timing_budget_s = 3.0;
  std::vector<TechniqueRun> runs;
  RegressGates gates;
  ErrorMetric metric = error_metric;  // what the known answers are asked of
};

/// The label of the case that says that a scene's truth is another; such a case has no numbers.
inline constexpr const char* kTruthLabel = "truth of the scene";

struct RegressCase {
  std::string scene;
  std::string label;
  CaseVerdict verdict;
  int samples_per_pixel = 0;        // of the truth, in the end
  int added_samples_per_pixel = 0;  // because it was not clear
  int pictures = 1;                 // of different seeds
  std::vector<std::string> notes;
  std::optional<BaselineRun> before, now;  // `now` is absent for a void run

  /// Whether an update takes it over: neither the same run nor as good.
  bool has_changed() const;
};

struct RegressScene {
  std::string name;
  std::string hash;
  TruthNumbers truth;
};

struct RegressResults {
  std::string suite;
  int width_px = 0;
  int height_px = 0;
  uint64_t seed = 0;
  std::vector<RegressScene> scenes;
  std::vector<RegressCase> cases;  // in the suite's order, stale ones last
  std::vector<Skip> skipped;

  size_t count(CaseOutcome outcome) const;
  bool passes() const { return count(CaseOutcome::fail) == 0; }
};

/// Every run on every scene. A failure must hold when the truth has its most samples and the technique three seeds.
RegressResults check_suite(std::span<const SceneJob> scenes, const RegressPlan& plan,
                           const Baseline& baseline, const RegressRenderers& renderers, Progress& progress);

/// The same without a baseline, at once with the most samples and three seeds: cases that pass have numbers for one.
RegressResults measure_suite(std::span<const SceneJob> scenes, const RegressPlan& plan,
                             const RegressRenderers& renderers, Progress& progress);

/// What was measured, as a baseline with one reason.
Baseline baseline_of(const RegressResults& measured, const BaselineReason& reason);

/// Takes over what the check found to be neither the same nor void: failures, improvements, new cases, other parameters; drops stale ones.
/// `measured` has those scenes and runs as measure_suite gives them. The reason names what changed.
Baseline updated(const Baseline& baseline, const RegressResults& checked, const RegressResults& measured,
                 BaselineReason reason);

}  // namespace umbrameter
