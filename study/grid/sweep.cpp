// SPDX-License-Identifier: Apache-2.0
#include "study/grid/sweep.h"

#include "core/guard.h"
#include "core/share_progress.h"
#include "lab/keep_score.h"
#include "lab/score.h"
#include "lab/stored_runs.h"
#include "lab/stored_truth.h"
#include "lab/technique_result.h"
#include "lab/validated.h"
#include "lab/verdicts.h"
#include "results/measured.h"

#include <fmt/format.h>

#include <algorithm>

namespace umbrameter {
namespace {

/// The truth of the scene at hand.
struct SweptTruth {
  std::optional<size_t> scene;  // index; absent: none yet
  std::optional<Image> image;   // absent: it failed
  SharedTruth shared;           // between its runs
};

/// The picture that verdicts are against.
struct BaselinePicture {
  std::string key;
  std::optional<StoredPicture> picture;  // absent: not stored
};

struct SweepContext {
  const SweepPlan& plan;
  std::span<const StudyScene> scenes;
  Renderers renderers;
  Store& store;
  const std::filesystem::path& scratch;
  ShareProgress progress;
  const SweepFailed& failed;
  SweptTruth truth;
  BaselinePicture baseline;
  SweepOutcome outcome;
};

LabelledRequest request_of(const SweepPlan& plan, const BenchRun& run) {
  return {run.technique.label, request_of(plan.picture, run.technique, run.seed)};
}

void report(SweepContext& context, const std::string& what, const Failure& failure) {
  const Failure named{failure.kind, fmt::format("{}: {}", what, failure.message)};
  context.outcome.failures.push_back(named);
  if (context.failed) context.failed(named);
}

void make_truth(SweepContext& context, size_t scene, const std::string& key) {
  const StudyScene& job = context.scenes[scene];
  const PictureQuality& picture = context.plan.picture;
  RecordHead head = make_head(job, picture, picture.seed);
  RenderedTruth truth;
  const auto failure = guarded([&] {
    truth = render_truth(context.renderers.reference, job.scene, request_of(picture), context.progress);
  });
  if (failure) return report(context, full_name(job), *failure);
  keep_truth(context.store, key, std::move(head), truth, context.scratch);
  ++context.outcome.references_rendered;
  context.truth.image = std::move(truth.frame.image);
}

/// From the store if it may and can, else rendered.
void require_truth(SweepContext& context, size_t scene, const std::string& key) {
  if (context.truth.scene == scene) return;
  context.truth = {scene, std::nullopt, {}};
  auto known = context.plan.reuse ? find_truth(context.store, key) : std::nullopt;
  if (!known) return make_truth(context, scene, key);
  context.truth.image = std::move(known->image);
}

/// The first frame, and when times are wanted those of more, in turn with the baseline's.
Frame render_frames(SweepContext& context, const PlanStep& step, size_t baseline, RunRecord& record) {
  const SweepPlan& plan = context.plan;
  std::vector<LabelledRequest> requests{request_of(plan, plan.runs[*step.run])};
  if (plan.timing && baseline != *step.run) requests.push_back(request_of(plan, plan.runs[baseline]));
  const TimingPlan timing = plan.timing.value_or(TimingPlan{.wanted_frames = 0});
  std::vector<TimedRun> runs = render_interleaved(
      context.renderers.realtime, context.scenes[step.scene].scene, requests, timing, context.progress);
  record.result.failure = runs.front().failure;
  if (record.result.failure) return {};
  take_frame(runs.front().frame, record.result);
  take_times(runs.front(), record.result);
  if (runs.size() > 1 && !runs[1].failure) record.baseline_times = summarise(runs[1].times);
  return std::move(runs.front().frame);
}

/// Counts which of the two is nearer to the truth.
void judge(SweepContext& context, const RunRecord& record, const StoredPicture& picture) {
  BaselinePicture& baseline = context.baseline;
  if (baseline.key != record.baseline)
    baseline = {record.baseline, find_picture(context.store, record.baseline)};
  if (!baseline.picture) return;
  const auto verdict =
      judge_runs({picture.image, picture.mask}, {baseline.picture->image, baseline.picture->mask}, "",
                 *context.truth.image);
  if (verdict) ++context.outcome.verdicts[verdict->outcome];
}

/// Notes why a run without failure says nothing.
void check_measured(SweepContext& context, const PlanStep& step, const std::optional<VisibilityError>& error,
                    size_t scorable_pixels) {
  const std::optional<std::string> reason =
      error ? unmeasured(error->scored_pixels, scorable_pixels)
            : std::optional<std::string>("the renderers see other surfaces");
  if (!reason) return;
  const std::string& label = context.plan.runs[*step.run].technique.label;
  context.outcome.unmeasured.push_back(
      fmt::format("{}, {}: not measured: {}", full_name(context.scenes[step.scene]), label, *reason));
}

/// Of the scene's first run of that seed; empty for itself.
std::string baseline_key(const SweepContext& context, const PlanStep& step, const std::string& reference) {
  const SweepPlan& plan = context.plan;
  const size_t baseline = baseline_of(plan, context.scenes[step.scene].scene, *step.run);
  if (baseline == *step.run) return {};
  const BenchRun& first = plan.runs[baseline];
  return run_key(reference, first.technique, first.seed, plan.metrics, plan.makers);
}

/// A run that a validation has is kept as a sweep's, and compared with its baseline.
bool take_validated(SweepContext& context, const PlanStep& step, const std::string& reference,
                    RunRecord validated) {
  require_truth(context, step.scene, reference);
  if (!context.truth.image) return false;
  const StudyScene& job = context.scenes[step.scene];
  const BenchRun& run = context.plan.runs[*step.run];
  const StoredPicture picture =
      swept_picture(context.store, validated, *context.truth.image, job.scene.camera);
  RunRecord record = swept(std::move(validated), run.technique.label);
  record.head.scene = job.name;
  record.head.camera = job.camera;
  record.baseline = baseline_key(context, step, reference);
  record.result.image_file = keep_image(context.store, picture.image, context.scratch);
  keep_record(context.store, step.key, record);
  check_measured(context, step, record.result.error,
                 static_cast<size_t>(std::ranges::count(scorable_mask(*context.truth.image), 1)));
  if (!record.baseline.empty()) judge(context, record, picture);
  return true;
}

void render_run(SweepContext& context, const PlanStep& step, const std::string& reference) {
  const StudyScene& job = context.scenes[step.scene];
  const SweepPlan& plan = context.plan;
  const BenchRun& run = plan.runs[*step.run];
  RunRecord record = make_record(run.technique, make_head(job, plan.picture, run.seed), reference);
  const size_t baseline = baseline_of(plan, job.scene, *step.run);
  record.baseline = baseline_key(context, step, reference);
  TechniqueResult& result = record.result;
  const Frame frame = render_frames(context, step, baseline, record);
  record.head.duration_s = result.wall_time_s;
  StoredPicture picture;
  if (!result.failure) {
    result.failure = guarded([&] {
      KeptScore kept = keep_score({context.store, context.scratch, plan.makers}, job.scene, frame.image,
                                  *context.truth.image, plan.metrics, context.truth.shared, record);
      check_measured(context, step, result.error, kept.scorable_pixels);
      picture = std::move(kept.picture);
    });
  }
  keep_record(context.store, step.key, record);
  ++context.outcome.rendered;
  if (result.failure)
    return report(context, fmt::format("{}, {}", full_name(job), result.label), *result.failure);
  if (!record.baseline.empty() && !picture.mask.empty()) judge(context, record, picture);
}

/// A stored failure is reported again.
void take_swept(SweepContext& context, const PlanStep& step, const RunRecord& record) {
  if (record.result.failure) {
    const std::string& label = context.plan.runs[*step.run].technique.label;
    const std::string what = fmt::format("{}, {}", full_name(context.scenes[step.scene]), label);
    return report(context, what, *record.result.failure);
  }
  const auto json = context.store.find(record.reference);
  const auto truth = json ? parse_reference_record(*json) : std::nullopt;
  if (truth) check_measured(context, step, record.result.error, truth->result.scorable_pixels);
}

/// Whether the store has the run.
bool take_stored(SweepContext& context, const PlanStep& step, const std::string& reference) {
  if (!context.plan.reuse) return false;
  StoredRun stored = find_run(context.store, step.key, context.plan.timing);
  if (!stored.record) return false;
  if (!stored.is_validation)
    take_swept(context, step, *stored.record);
  else if (!take_validated(context, step, reference, *std::move(stored.record)))
    return false;
  ++context.outcome.reused;
  return true;
}

void do_run(SweepContext& context, const PlanStep& step, const std::string& reference) {
  if (step.action == StepAction::skip) {
    ++context.outcome.skipped;
    return;
  }
  if (take_stored(context, step, reference)) return;
  require_truth(context, step.scene, reference);
  if (!context.truth.image) {
    ++context.outcome.not_done;
    return;
  }
  render_run(context, step, reference);
}

/// Weight of a step on the bar.
uint64_t milliseconds_of(const PlanStep& step) {
  return step.action == StepAction::render ? 1 + static_cast<uint64_t>(1000.0 * step.estimated_s) : 0;
}

}  // namespace

SweepOutcome run_sweep(const SweepPlan& plan, std::span<const StudyScene> scenes,
                       std::span<const PlanStep> steps, Renderers renderers, Store& store,
                       const std::filesystem::path& scratch, Progress& progress, const SweepFailed& failed) {
  uint64_t total_ms = 0;
  for (const PlanStep& step : steps) total_ms += milliseconds_of(step);
  progress.begin(fmt::format("sweep of {} runs",
                             std::ranges::count_if(steps,
                                                   [](const PlanStep& step) {
                                                     return step.run && step.action == StepAction::render;
                                                   })),
                 total_ms);
  SweepContext context{plan, scenes, renderers, store, scratch, ShareProgress(progress), failed, {}, {}, {}};
  std::string reference;  // key, of the scene at hand
  for (const PlanStep& step : steps) {
    context.progress.start_share(milliseconds_of(step));
    if (!step.run) reference = step.key;
    if (!step.run && step.action == StepAction::render) require_truth(context, step.scene, step.key);
    if (step.run) do_run(context, step, reference);
    context.progress.end_share();
  }
  progress.end();
  return context.outcome;
}

}  // namespace umbrameter
