// SPDX-License-Identifier: Apache-2.0
#pragma once
// Time against error of the truth itself: one scene at a series of settings. Sees only Renderer&.

#include "core/renderer.h"
#include "results/bench/truth_curve.h"

#include <memory>
#include <string>
#include <vector>

namespace umbrameter {

/// A renderer of the truth and what it was made with.
struct TruthSetting {
  std::string kind;      // "target_se" or "samples"
  double setting = 0.0;  // the wanted standard error, or samples a pixel
  std::unique_ptr<Renderer> renderer;
};

struct TruthPlan {
  std::vector<TruthSetting> settings;  // empty: the truth is not measured
  int repetitions = 5;
};

/// Renders every setting in turn, `repetitions` times, after the scene is built. The error is the mean of (V - A)(V - B)
/// with A and B the halves of a picture of other samples from the last setting by target_se, so that its noise is not
/// counted. `request` says size and seed.
TruthCurve measure_truth(const Scene& scene, const RenderRequest& request, const TruthPlan& plan,
                         Progress& progress);

}  // namespace umbrameter
