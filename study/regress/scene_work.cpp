// SPDX-License-Identifier: Apache-2.0
#include "study/regress/scene_work.h"

#include "core/guard.h"
#include "core/hash.h"
#include "lab/examine.h"
#include "lab/timing.h"
#include "metrics/statistics/frame_times.h"
#include "metrics/statistics/seed_noise.h"
#include "results/catalogue.h"
#include "results/metadata.h"
#include "results/regress/case_json.h"
#include "store/code_hashes.h"

#include <nlohmann/json.hpp>

#include <cmath>

namespace umbrameter {
namespace {

std::string void_message(const GateRun& run) {
  if (run.failure) return run.failure->message;
  if (!run.metric_problems.empty()) return run.metric_problems.front();
  if (!run.truth_problems.empty()) return run.truth_problems.front();
  return run.is_other_light ? "the renderers see the same surfaces under another light"
                            : "the renderers see other surfaces";
}

/// Times are always taken anew, and with them the pictures.
bool keeps_answers(const SceneWork& work) {
  return work.renderers.answers != nullptr && work.plan.timed_frames == 0;
}

void draw_next(const SceneWork& work, RunWork& run) {
  const uint64_t seed = work.plan.picture.seed + kSeedStep * run.pictures.size();
  const RenderRequest request = request_of(work.plan.picture, run.run, seed);
  run.failure = guarded([&] {
    Frame frame = work.renderers.realtime.render(work.job.scene, request, work.progress);
    run.described.parameters = to_text(frame.parameters);
    run.described.device = frame.device;
    run.pictures.push_back(std::move(frame.image));
  });
}

void time_first_pictures(const SceneWork& work, std::vector<RunWork>& runs) {
  std::vector<LabelledRequest> requests;
  for (const RunWork& run : runs)
    requests.push_back({run.run.label, request_of(work.plan.picture, run.run, work.plan.picture.seed)});
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
}

Measured measure_pictures(const SceneWork& work, RunWork& run, const Image& truth) {
  std::vector<CaseNumbers> all;
  for (const Image& picture : run.pictures) {
    Examined examined = examine(picture, truth, work.job.scene.camera.eye_world, work.plan.metric);
    const GateVerdict verdict = judge_gate(examined.run, nullptr, false, gate_limits());
    const bool is_void = verdict.measures.empty();
    if (is_void) return {not_compared(std::string(name_of(*verdict.kind)), void_message(examined.run)), {}};
    auto numbers = case_numbers(examined.run);
    if (!numbers) return {not_compared("nothing", "no pixel could be scored"), {}};
    all.push_back(std::move(*numbers));
    run.mask = std::move(examined.mask);
  }
  return {{}, mean_of(all)};
}

std::string key_of(const SceneWork& work, const RunWork& run, const Truth& truth,
                   const std::optional<double>& seed_sd) {
  const PictureQuality& picture = work.plan.picture;
  Hasher hasher;
  hasher.text("regress").text(kRegressCodeHash).text(truth.key());
  hasher.text(run_key(reference_key(work.job.scene, picture, work.renderers.makers), run.run, picture.seed,
                      {}, work.renderers.makers));
  return hasher.number(static_cast<double>(run.seeds)).number(seed_sd ? 1.0 : 0.0).hex();
}

}  // namespace

void Truth::grow_to(int samples) {
  if (samples <= samples_) return;
  parts_.push_back(samples - samples_);
  samples_ = samples;
}

const Image& Truth::image() {
  for (; rendered_ < parts_.size(); ++rendered_) {
    const auto renderer = work_.renderers.make_reference(parts_[rendered_]);
    RenderRequest request = request_of(work_.plan.picture);
    request.seed += kSeedStep * rendered_;
    Frame frame = renderer->render(work_.job.scene, request, work_.progress);
    if (rendered_ == 0) {
      image_ = std::move(frame.image);
      device_ = frame.device;
    } else {
      add_samples(image_, frame.image);
    }
  }
  return image_;
}

std::string Truth::key() const {
  Hasher hasher;
  for (const int samples : parts_) hasher.number(samples);
  return hasher.text(reference_key(work_.job.scene, work_.plan.picture, work_.renderers.makers)).hex();
}

TruthNumbers Truth::numbers() {
  TruthNumbers numbers;
  const std::string key = Hasher().text("truth numbers").text(kRegressCodeHash).text(this->key()).hex();
  Answers* const answers = work_.renderers.answers;
  if (answers != nullptr && answers->find(key, [&](const auto& json) { read_answer(json, numbers); }))
    return numbers;
  numbers = truth_numbers(image(), device_, work_.plan.picture.seed);
  if (answers != nullptr) answers->keep(key, answer_json(numbers));
  return numbers;
}

std::vector<RunWork> choose_runs(const SceneWork& work, std::vector<Skip>& skipped) {
  std::vector<RunWork> runs;
  for (const TechniqueRun& run : work.plan.runs) {
    if (const auto reason = skip_reason(run, work.job.scene)) {
      skipped.push_back({work.job.name, run.label, *reason});
      continue;
    }
    runs.push_back({run, 1, {}, {}, {run.label, run.id, run.hash, "", "", {}, {}}, {}});
  }
  if (work.plan.timed_frames > 0) time_first_pictures(work, runs);
  return runs;
}

Measured measure(const SceneWork& work, RunWork& run, Truth& truth, std::optional<double> seed_sd) {
  const std::string key = key_of(work, run, truth, seed_sd);
  Measured measured;
  const bool is_known = keeps_answers(work) && work.renderers.answers->find(key, [&](const auto& json) {
    read_answer(json, measured, run.described);
  });
  if (!is_known) {
    while (!run.failure && run.pictures.size() < run.seeds) draw_next(work, run);
    if (run.failure) return {not_compared("failure", run.failure->message), {}};
    measured = measure_pictures(work, run, truth.image());
    if (measured.numbers && !seed_sd)
      measured.numbers->seed_sd = seed_noise_of_mse(run.pictures, truth.image(), run.mask);
    if (keeps_answers(work)) work.renderers.answers->keep(key, answer_json(measured, run.described));
  }
  if (measured.numbers && seed_sd)
    measured.numbers->seed_sd = *seed_sd / std::sqrt(static_cast<double>(run.seeds));
  return measured;
}

}  // namespace umbrameter
