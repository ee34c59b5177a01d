#pragma once
// Draws a plan.

#include "realtime/executor/plan.h"
#include "realtime/harness/timers.h"

namespace umbrameter {

/// One frame. With `timers` (labels: the plan's) each run of equal labels is timed; without, GL errors are
/// checked after every pass and name it.
void draw_frame(const Plan& plan, const SceneBuffers& scene_buffers, const VertexArray& empty_vertex_array,
                PassTimers* timers);

}  // namespace umbrameter
