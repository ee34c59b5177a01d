// SPDX-License-Identifier: Apache-2.0
#include "study/causes/run_causes.h"

#include "core/clock.h"
#include "study/causes/find_causes.h"
#include "study/guard.h"
#include "study/picture_classes.h"

#include <algorithm>
#include <functional>

namespace umbrameter {
namespace {

bool has_causes(const TechniqueFrame& run) {
  return run.result.error && run.result.error->rmse && run.result.diagnosis &&
         worst_fault(run.result.diagnosis->faults) && !run.technique.declared.empty();
}

double rmse_of(const TechniqueFrame* run) {
  return run->result.error->rmse->value;
}

/// Truth, pictures and their times: what the scene would take without causes.
double scene_time_s(const SceneResult& scene, std::span<const TechniqueFrame> runs) {
  double sum_s = scene.reference ? scene.reference->wall_time_s : 0.0;
  for (const TechniqueFrame& run : runs) {
    sum_s += run.result.wall_time_s + run.scoring_s;
    for (const PassTime& time : run.result.pass_times) sum_s += 1e-3 * time.median_ms * time.frames;
  }
  return sum_s;
}

/// The first picture's time holds compilation and the scene's way to the GPU, which are not needed again.
double picture_time_s(const TechniqueResult& run) {
  const auto frame = total_time(run.pass_times);
  return frame ? 1e-3 * frame->median_ms : run.wall_time_s;
}

SubstitutedRun substituted(const SceneContext& context, const TechniqueFrame& run) {
  return {run.technique.declared, run.result.parameters, context.scene.light(),
          context.scene.bounds_world.diagonal(), run.result.memory_bytes};
}

/// One copy of the scene, whose light is changed from picture to picture.
class Redraw {
 public:
  Redraw(const SceneContext& context, const Image& reference, const TechniqueFrame& run)
      : context_(context), reference_(reference), run_(run), scene_(context.scene) {}

  Image operator()(const Replacement& replacement, const Light& light) {
    scene_.lights[scene_.active_light] = light;
    RenderRequest request = request_of(context_.plan.picture, run_.technique, context_.plan.picture.seed);
    request.parameters = replacement.parameters;
    if (replacement.takes_blocker_truth) request.blocker_truth = &reference_;
    return context_.renderers.realtime.render(scene_, request, context_.progress).image;
  }

 private:
  const SceneContext& context_;
  const Image& reference_;
  const TechniqueFrame& run_;
  Scene scene_;
};

FaultCauses causes_of(const SceneContext& context, const Image& reference, TechniqueFrame& run) {
  require_picture(context, reference, run);
  const auto classes = read_fault_picture(context.folder / run.result.fault_picture_file);
  return find_causes(substituted(context, run), {run.frame.image, reference, classes},
                     named_faults(run.result.diagnosis->faults), Redraw(context, reference, run));
}

}  // namespace

std::vector<TechniqueFrame*> runs_without_causes(const ValidationPlan& plan, std::span<TechniqueFrame> runs) {
  std::vector<TechniqueFrame*> chosen;
  if (plan.causes == CausesWanted::none) return chosen;
  for (TechniqueFrame& run : runs) {
    if (has_causes(run)) chosen.push_back(&run);
  }
  std::ranges::stable_sort(chosen, std::ranges::greater{}, rmse_of);
  if (plan.causes != CausesWanted::all && chosen.size() > kWorstRuns) chosen.resize(kWorstRuns);
  std::erase_if(chosen, [](const TechniqueFrame* run) { return run->result.fault_causes.has_value(); });
  return chosen;
}

void find_run_causes(const SceneContext& context, const Image& reference, const SceneResult& scene,
                     std::span<TechniqueFrame> runs) {
  const std::vector<TechniqueFrame*> chosen = runs_without_causes(context.plan, runs);
  if (chosen.empty()) return;
  const double allowed_s = scene_time_s(scene, runs);
  const Clock::time_point start = Clock::now();
  context.progress.begin("causes", chosen.size());
  for (TechniqueFrame* run : chosen) {
    const double needed_s = draws_of_causes(substituted(context, *run)) * picture_time_s(run->result);
    const bool is_too_dear =
        context.plan.causes == CausesWanted::automatic && seconds_since(start) + needed_s > allowed_s;
    FaultCauses causes;
    if (is_too_dear) {
      causes.skipped =
          fmt::format("would take about {:.2g} s, the scene itself took {:.2g} s; '--causes worst' does",
                      needed_s, allowed_s);
    } else if (const auto failure = guarded([&] { causes = causes_of(context, reference, *run); })) {
      causes.skipped = failure->message;
    }
    run->result.fault_causes = std::move(causes);
    context.progress.advance(1);
  }
  context.progress.end();
}

}  // namespace umbrameter
