// SPDX-License-Identifier: Apache-2.0
#include "lab/run_causes.h"

#include "core/guard.h"
#include "lab/causes/blocker_extension.h"
#include "lab/causes/find_causes.h"
#include "results/pictures/picture_classes.h"

#include <algorithm>
#include <functional>
#include <optional>

namespace umbrameter {
namespace {

// What takes about as long as one picture of pcss or pcf_disk, measured with software GL and Embree on the same cores
// (docs/causes.md).
constexpr double kSamplesPerPicture = 25.0;  // of the truth, a pixel
constexpr double kPicturesPerScore = 4.0;

bool has_causes(const TechniqueFrame& run) {
  return run.result.error && run.result.error->rmse && run.result.diagnosis &&
         worst_fault(run.result.diagnosis->faults) && !run.technique.declared.empty();
}

bool knows_causes(const TechniqueFrame* run) {
  return run->result.fault_causes.has_value();
}

double rmse_of(const TechniqueFrame* run) {
  return run->result.error->rmse->value;
}

/// What the scene takes without causes, in pictures. What was planned and not what was done: the same whatever the clock
/// says and whatever was known before.
double pictures_of_scene(const ValidationPlan& plan, const SceneResult& scene, size_t runs) {
  const double samples = scene.reference ? scene.reference->mean_sample_count : 0.0;
  const double pictures = 1.0 + plan.timed_frames + kPicturesPerScore;
  return samples / kSamplesPerPicture + pictures * static_cast<double>(runs);
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
    if (replacement.takes_blocker_truth) request.blocker_truth = &blockers();
    return context_.renderers.realtime.render(scene_, request, context_.progress).image;
  }

 private:
  /// Made when first asked for: not every truth has what it is made of.
  const Image& blockers() {
    if (!blockers_) blockers_ = extended_blockers(reference_);
    return *blockers_;
  }

  const SceneContext& context_;
  const Image& reference_;
  std::optional<Image> blockers_;
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

std::vector<TechniqueFrame*> runs_with_wanted_causes(const ValidationPlan& plan,
                                                     std::span<TechniqueFrame> runs) {
  std::vector<TechniqueFrame*> chosen;
  if (plan.causes == CausesWanted::none) return chosen;
  for (TechniqueFrame& run : runs) {
    if (has_causes(run)) chosen.push_back(&run);
  }
  std::ranges::stable_sort(chosen, std::ranges::greater{}, rmse_of);
  if (plan.causes != CausesWanted::all && chosen.size() > kWorstRuns) chosen.resize(kWorstRuns);
  return chosen;
}

void find_run_causes(const SceneContext& context, const Image& reference, const SceneResult& scene,
                     std::span<TechniqueFrame> runs, const RunDone& run_done) {
  const std::vector<TechniqueFrame*> chosen = runs_with_wanted_causes(context.plan, runs);
  if (std::ranges::all_of(chosen, knows_causes)) return;
  const double allowed = pictures_of_scene(context.plan, scene, runs.size());
  double spent = 0.0;
  context.progress.begin("causes", chosen.size());
  for (TechniqueFrame* run : chosen) {
    context.progress.advance(1);
    const double needed = draws_of_causes(substituted(context, *run));
    const bool is_too_dear = context.plan.causes == CausesWanted::automatic && spent + needed > allowed;
    spent += is_too_dear ? 0.0 : needed;
    if (knows_causes(run)) continue;
    FaultCauses causes;
    if (is_too_dear) {
      causes.skipped = fmt::format(
          "would take about {:.0f} pictures, the scene itself takes {:.0f}{}; '--causes worst' does", needed,
          allowed, spent > 0.0 ? fmt::format(", of which others' causes took {:.0f}", spent) : "");
    } else if (const auto failure = guarded([&] { causes = causes_of(context, reference, *run); })) {
      causes.skipped = failure->message;
    }
    run->result.fault_causes = std::move(causes);
    run_done(*run);
  }
  context.progress.end();
}

}  // namespace umbrameter
