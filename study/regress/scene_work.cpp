// SPDX-License-Identifier: Apache-2.0
#include "study/regress/scene_work.h"

#include "lab/timing.h"
#include "metrics/frame_times.h"
#include "results/guard.h"
#include "results/metadata.h"
#include "study/stage.h"

namespace umbrameter {
namespace {

std::string void_message(const GateRun& run) {
  if (run.failure) return run.failure->message;
  if (!run.metric_problems.empty()) return run.metric_problems.front();
  if (!run.truth_problems.empty()) return run.truth_problems.front();
  return run.is_other_light ? "the renderers see the same surfaces under another light"
                            : "the renderers see other surfaces";
}

}  // namespace

void Truth::grow_to(int samples) {
  if (samples <= samples_) return;
  const auto renderer = work_.renderers.make_reference(samples - samples_);
  RenderRequest request = request_of(work_.plan.picture);
  request.seed += kSeedStep * parts_++;
  Frame frame = renderer->render(work_.job.scene, request, work_.progress);
  if (samples_ == 0) {
    image_ = std::move(frame.image);
    device_ = frame.device;
  } else {
    add_samples(image_, frame.image);
  }
  samples_ = samples;
}

std::vector<RunWork> first_pictures(const SceneWork& work, std::vector<Skip>& skipped) {
  std::vector<RunWork> runs;
  std::vector<LabelledRequest> requests;
  for (const TechniqueRun& run : work.plan.runs) {
    if (const auto reason = skip_reason(run, work.job.scene)) {
      skipped.push_back({work.job.name, run.label, *reason});
      continue;
    }
    runs.push_back({run, {}, {}, {run.label, run.id, run.hash, "", "", {}, {}}, {}});
    requests.push_back({run.label, request_of(work.plan.picture, run, work.plan.picture.seed)});
  }
  const TimingPlan timing = {work.plan.timed_frames, work.plan.timing_budget_s};
  std::vector<TimedRun> timed =
      render_interleaved(work.renderers.realtime, work.job.scene, requests, timing, work.progress);
  for (size_t k = 0; k < runs.size(); ++k) {
    runs[k].failure = timed[k].failure;
    if (runs[k].failure) continue;
    runs[k].described.parameters = to_text(timed[k].frame.parameters);
    runs[k].described.device = timed[k].frame.device;
    if (const auto total = total_time(summarise(timed[k].times)))
      runs[k].described.time = BaselineTime{total->median_ms, total->mad_ms, total->frames};
    runs[k].pictures.push_back(std::move(timed[k].frame.image));
  }
  return runs;
}

void add_picture(const SceneWork& work, RunWork& run) {
  const uint64_t seed = work.plan.picture.seed + kSeedStep * run.pictures.size();
  run.failure = guarded([&] {
    const RenderRequest request = request_of(work.plan.picture, run.run, seed);
    Frame frame = work.renderers.realtime.render(work.job.scene, request, work.progress);
    run.pictures.push_back(std::move(frame.image));
  });
}

Measured measure(const SceneWork& work, RunWork& run, const Image& truth, double seed_sd) {
  GateRun failed;
  failed.failure = run.failure;
  std::vector<CaseNumbers> all;
  for (const Image& picture : run.pictures) {
    if (failed.failure) break;
    Examined examined = examine(picture, truth, work.job.scene.camera.eye_world, work.plan.metric);
    const GateVerdict verdict = judge_gate(examined.run, nullptr, false);
    const bool is_void = verdict.measures.empty();
    if (is_void) return {not_compared(std::string(name_of(*verdict.kind)), void_message(examined.run)), {}};
    auto numbers = case_numbers(examined.run);
    if (!numbers) return {not_compared("nothing", "no pixel could be scored"), {}};
    numbers->seed_sd = seed_sd;
    all.push_back(std::move(*numbers));
    run.mask = std::move(examined.mask);
  }
  if (failed.failure) return {not_compared("failure", failed.failure->message), {}};
  return {{}, mean_of(all)};
}

}  // namespace umbrameter
