#include "study/sweep/sweep.h"

#include "core/clock.h"
#include "core/image_io.h"
#include "study/guard.h"
#include "study/metadata.h"
#include "study/scene_run.h"
#include "study/score.h"
#include "study/sweep/record.h"
#include "study/sweep/share_progress.h"
#include "umbrameter_version.h"

#include <fmt/format.h>

#include <algorithm>

namespace umbrameter {
namespace {

/// The truth of the scene at hand.
struct Truth {
  std::optional<size_t> scene;  // index; absent: none yet
  std::optional<Image> image;   // absent: it failed
  SharedTruth shared;           // between its runs
};

struct Context {
  const SweepPlan& plan;
  std::span<const SceneJob> scenes;
  Renderers renderers;
  Store& store;
  const std::filesystem::path& scratch;
  ShareProgress progress;
  const SweepFailed& failed;
  Truth truth;
  SweepOutcome outcome;
};

RenderRequest request_of(const SweepPlan& plan, uint64_t seed) {
  RenderRequest request;
  request.width_px = plan.quality.width_px;
  request.height_px = plan.quality.height_px;
  request.seed = seed;
  return request;
}

RecordHead head_of(const Context& context, const SceneJob& job, uint64_t seed) {
  const PictureQuality& quality = context.plan.quality;
  RecordHead head;
  head.scene = job.name;
  head.scene_hash = job.scene.hash;
  head.light = to_text(job.scene.light().type);
  head.width_px = quality.width_px;
  head.height_px = quality.height_px;
  head.samples_per_pixel = quality.samples_per_pixel;
  head.target_se = quality.target_se;
  head.seed = seed;
  head.commit = UMBRAMETER_COMMIT;
  head.started = time_now();
  return head;
}

std::string keep(const Context& context, const Image& image) {
  const std::filesystem::path file = context.scratch / "image.exr";
  write_exr(file, image);
  return context.store.keep(file);
}

void report(Context& context, const std::string& what, const Failure& failure) {
  const Failure named{failure.kind, fmt::format("{}: {}", what, failure.message)};
  context.outcome.failures.push_back(named);
  if (context.failed) context.failed(named);
}

void render_truth(Context& context, const PlanStep& step) {
  const SceneJob& job = context.scenes[step.scene];
  const uint64_t seed = context.plan.quality.reference_seed;
  const RenderRequest request = request_of(context.plan, seed);
  const Clock::time_point start = Clock::now();
  ReferenceRecord record{head_of(context, job, seed), {}};
  Frame frame;
  const auto failure = guarded([&] {
    frame = context.renderers.reference.render(job.scene, request, context.progress);
    summarise_errors(frame.image, record.result);
  });
  if (failure) return report(context, job.name, *failure);
  record.head.duration_s = seconds_since(start);
  record.result.device = frame.device;
  record.result.wall_time_s = frame.wall_time_s;
  record.result.warnings = frame.warnings;
  add_metadata(frame, job.scene, request);
  record.result.image_file = keep(context, frame.image);
  context.store.put({step.key, EntryKind::reference, to_json_text(record)});
  ++context.outcome.references_rendered;
  context.truth.image = std::move(frame.image);
}

/// From the store if it may and can, else rendered.
void require_truth(Context& context, size_t scene, const std::string& key) {
  if (context.truth.scene == scene) return;
  context.truth = {scene, std::nullopt, {}};
  if (context.plan.reuse) {
    const auto json = context.store.find(key);
    const auto record = json ? parse_reference_record(*json) : std::nullopt;
    if (record) context.truth.image = read_image(context.store.path_of(record->result.image_file));
    if (record) return;
  }
  PlanStep step;
  step.scene = scene;
  step.key = key;
  render_truth(context, step);
}

Image visibility_of(const Image& image) {
  Image visibility(image.width, image.height);
  std::ranges::copy(image.plane("visibility"), visibility.add_plane("visibility").begin());
  return visibility;
}

void take_score(const Score& score, RunRecord& record) {
  record.parity = parity_numbers(score.parity, ParityTolerance{}.required_agreement);
  record.result.error = score.error;
  record.result.judgement = score.judgement;
  record.result.diagnosis = score.diagnosis;
  record.result.similarity = score.similarity;
  if (score.no_diagnosis)
    record.result.warnings.push_back("the faults could not be told apart: " + score.no_diagnosis->message);
}

void take_frame(const Frame& frame, TechniqueResult& result) {
  result.parameters = frame.parameters;
  result.device = frame.device;
  result.memory_bytes = frame.memory_bytes;
  result.wall_time_s = frame.wall_time_s;
  result.warnings = frame.warnings;
}

void render_run(Context& context, const PlanStep& step, const std::string& reference) {
  const SceneJob& job = context.scenes[step.scene];
  const BenchRun& run = context.plan.runs[*step.run];
  const Clock::time_point start = Clock::now();
  RunRecord record{head_of(context, job, run.seed), reference, {}, {}};
  TechniqueResult& result = record.result;
  result.label = run.technique.label;
  result.technique = run.technique.id;
  result.title = run.technique.title;
  result.hash = run.technique.hash;
  result.parameters = run.technique.parameters;
  RenderRequest request = request_of(context.plan, run.seed);
  request.technique = run.technique.technique;
  request.parameters = run.technique.parameters;
  MetricChoice metrics = context.plan.metrics;
  metrics.verdict = false;  // a verdict is of two runs
  Frame frame;
  result.failure = guarded([&] {
    frame = context.renderers.realtime.render(job.scene, request, context.progress);
    take_frame(frame, result);
    take_score(score_image(frame.image, *context.truth.image, job.scene.camera.eye_world, {metrics, {}},
                           &context.truth.shared),
               record);
  });
  record.head.duration_s = seconds_since(start);
  if (!result.failure) result.image_file = keep(context, visibility_of(frame.image));
  context.store.put({step.key, EntryKind::run, to_json_text(record)});
  ++context.outcome.rendered;
  if (result.failure) report(context, fmt::format("{}, {}", job.name, result.label), *result.failure);
}

/// Whether the run is in the store; its failure is reported again.
bool take_stored(Context& context, const PlanStep& step) {
  if (!context.plan.reuse) return false;
  const auto json = context.store.find(step.key);
  const auto stored = json ? parse_run_record(*json) : std::nullopt;
  if (!stored) return false;
  const auto& failure = stored->result.failure;
  if (failure && failure->kind != ErrorKind::input) return false;
  ++context.outcome.reused;
  const std::string& label = context.plan.runs[*step.run].technique.label;
  if (failure) report(context, fmt::format("{}, {}", context.scenes[step.scene].name, label), *failure);
  return true;
}

void do_run(Context& context, const PlanStep& step, const std::string& reference) {
  if (step.action == StepAction::skip) {
    ++context.outcome.skipped;
    return;
  }
  if (take_stored(context, step)) return;
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

SweepOutcome run_sweep(const SweepPlan& plan, std::span<const SceneJob> scenes,
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
  Context context{plan, scenes, renderers, store, scratch, ShareProgress(progress), failed, {}, {}};
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
