// SPDX-License-Identifier: Apache-2.0
#pragma once
// Draws a plan.

#include "core/progress.h"
#include "realtime/executor/plan.h"
#include "realtime/harness/timers.h"

namespace umbrameter {

struct FrameWatch {
  PassTimers* timers = nullptr;  // with the plan's labels: each run of equal labels is timed
  bool is_first = true;          // the plan's first frame, which also draws what runs once
  Progress* progress =
      nullptr;  // one step per draw; the first frame of a plan, which also checks GL errors per pass
};

/// One frame. Without `watch.progress` nothing but binding and drawing happens.
void draw_frame(const Plan& plan, const SceneBuffers& scene_buffers, const VertexArray& empty_vertex_array,
                const FrameWatch& watch);

}  // namespace umbrameter
