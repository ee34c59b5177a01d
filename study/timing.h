#pragma once
// How many frames to time.

#include "core/renderer.h"

namespace umbrameter {

struct TimingPlan {
  int wanted_frames = 9;  // 0 = no timing
  double budget_s = 3.0;
};

/// Renders with one timed frame, then again with as many as fit the budget, at most `wanted_frames`. A
/// technique so slow that two do not fit keeps its one.
Frame render_timed(Renderer& renderer, const Scene& scene, RenderRequest request, const TimingPlan& plan,
                   Progress& progress);

}  // namespace umbrameter
