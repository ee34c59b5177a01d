// SPDX-License-Identifier: Apache-2.0
#pragma once
// Renders what a suite names and judges it against a baseline, or makes one. Sees only Renderer&.

#include "lab/answers.h"
#include "lab/keys.h"
#include "metrics/metric_probe.h"
#include "results/regress/outcome.h"
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

/// Every run on every scene. A failure must hold when the truth has its most samples and the technique three seeds.
RegressResults check_suite(std::span<const SceneJob> scenes, const RegressPlan& plan,
                           const Baseline& baseline, const RegressRenderers& renderers, Progress& progress);

/// The same without a baseline, at once with the most samples and three seeds: cases that pass have numbers for one.
RegressResults measure_suite(std::span<const SceneJob> scenes, const RegressPlan& plan,
                             const RegressRenderers& renderers, Progress& progress);

}  // namespace umbrameter
