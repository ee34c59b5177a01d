// SPDX-License-Identifier: Apache-2.0
#pragma once
// Renders runs on one scene and times their frames in turn: A B C A B C ..., so that whatever changes while the clock
// runs (heat, other programs) changes all of them alike.

#include "core/renderer.h"
#include "metrics/statistics/frame_times.h"
#include "results/results.h"
#include "results/timing_plan.h"

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace umbrameter {

struct LabelledRequest {
  std::string label;  // for the progress
  RenderRequest request;
};

struct TimedRun {
  std::optional<Failure> failure;  // then the rest says nothing
  Frame frame;
  FrameTimes times;  // of the frames after the warm-up
  std::string timer;
};

/// Called with a run's index and first frame before anything is timed; what it throws is the run's failure. May take
/// the image away.
using FirstFrame = std::function<void(size_t, Frame&)>;

/// One result a request, in order. A run that throws is recorded and the rest goes on (Error{cancelled} passes
/// through). Runs whose textures do not fit 2 GiB together are timed in groups.
std::vector<TimedRun> render_interleaved(Renderer& renderer, const Scene& scene,
                                         std::span<const LabelledRequest> requests, const TimingPlan& plan,
                                         Progress& progress, const FirstFrame& first_frame = {});

}  // namespace umbrameter
