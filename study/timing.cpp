#include "study/timing.h"

#include "study/results.h"

#include <algorithm>

namespace umbrameter {

Frame render_timed(Renderer& renderer, const Scene& scene, RenderRequest request, const TimingPlan& plan,
                   Progress& progress) {
  request.timed_frames = std::min(plan.wanted_frames, 1);
  Frame frame = renderer.render(scene, request, progress);
  const auto total = total_time(frame.pass_times);
  if (!total || plan.wanted_frames <= 1) return frame;
  const double budget_ms = 1000.0 * plan.budget_s;
  if (total->median_ms * 2.0 > budget_ms) return frame;
  const double affordable = budget_ms / std::max(total->median_ms, 1e-3);
  request.timed_frames = static_cast<int>(std::min<double>(affordable, plan.wanted_frames));
  return renderer.render(scene, request, progress);
}

}  // namespace umbrameter
