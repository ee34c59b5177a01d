#include "study/scene_run.h"

#include "core/image_io.h"
#include "study/guard.h"
#include "study/metadata.h"
#include "study/pictures.h"
#include "study/score.h"
#include "study/timing.h"

#include <fmt/format.h>

#include <algorithm>

namespace umbrameter {
namespace {

void save_image(const SceneContext& context, const std::string& file, const Image& image) {
  write_exr(context.folder / file, image);
}

void save_picture(const SceneContext& context, const std::string& file, const Picture& picture) {
  write_picture(context.folder / file, picture);
}

TechniqueResult describe(const TechniqueRun& run) {
  TechniqueResult result;
  result.label = run.label;
  result.technique = run.id;
  result.title = run.title;
  result.hash = run.hash;
  result.parameters = run.parameters;
  return result;
}

/// Every run of the plan that supports the scene's light, undone; the others join `skipped`.
std::vector<TechniqueFrame> choose_runs(const SceneContext& context, std::vector<Skip>& skipped,
                                        std::vector<LabelledRequest>& requests) {
  std::vector<TechniqueFrame> frames;
  for (const TechniqueRun& run : context.plan.techniques) {
    if (const auto reason = skip_reason(run, context.job.scene)) {
      skipped.push_back({context.job.name, run.label, *reason});
      continue;
    }
    RenderRequest request = request_of(context.plan);
    request.technique = run.technique;
    request.parameters = run.parameters;
    requests.push_back({run.label, request});
    frames.push_back({describe(run), {}, {}});
  }
  return frames;
}

void take_result(TimedRun& run, TechniqueFrame& out) {
  TechniqueResult& result = out.result;
  result.failure = run.failure;
  if (result.failure) return;
  out.frame = std::move(run.frame);
  result.parameters = out.frame.parameters;
  result.pass_times = summarise(run.times);
  result.timer = run.timer;
  result.device = out.frame.device;
  result.memory_bytes = out.frame.memory_bytes;
  result.wall_time_s = out.frame.wall_time_s;
  result.warnings = out.frame.warnings;
}

}  // namespace

std::string SceneContext::relative(const std::string& file) const {
  return "images/" + file_name_of(job.name) + "/" + file;
}

void summarise_errors(const Image& image, ReferenceResult& result) {
  const auto se = image.plane("visibility_se");
  const auto samples = image.plane("sample_count");
  const auto primitive = image.plane("primitive_id");
  double covered = 0.0;
  for (size_t i = 0; i < se.size(); ++i) {
    if (primitive[i] < 0.0f) continue;
    covered += 1.0;
    result.mean_visibility_se += static_cast<double>(se[i]);
    result.mean_sample_count += static_cast<double>(samples[i]);
    result.max_visibility_se = std::max(result.max_visibility_se, static_cast<double>(se[i]));
  }
  if (covered == 0.0) return;
  result.mean_visibility_se /= covered;
  result.mean_sample_count /= covered;
}

RenderRequest request_of(const ValidationPlan& plan) {
  return {.width_px = plan.width_px,
          .height_px = plan.height_px,
          .seed = plan.seed,
          .technique = {},
          .parameters = {}};
}

std::vector<TechniqueFrame> render_techniques(const SceneContext& context, std::vector<Skip>& skipped) {
  std::vector<LabelledRequest> requests;
  std::vector<TechniqueFrame> frames = choose_runs(context, skipped, requests);
  const TimingPlan timing{context.plan.timed_frames, context.plan.timing_budget_s};
  std::vector<TimedRun> runs =
      render_interleaved(context.renderers.realtime, context.job.scene, requests, timing, context.progress);
  for (size_t i = 0; i < runs.size(); ++i) {
    take_result(runs[i], frames[i]);
    TechniqueResult& result = frames[i].result;
    if (result.failure) continue;
    add_metadata(frames[i].frame, context.job.scene, requests[i].request);
    result.image_file = context.relative(file_name_of(result.label) + ".exr");
    save_image(context, result.image_file, frames[i].frame.image);
  }
  return frames;
}

Frame render_reference(const SceneContext& context, SceneResult& scene) {
  Frame frame;
  const RenderRequest request = request_of(context.plan);
  ReferenceResult result;
  scene.failure = guarded([&] {
    frame = context.renderers.reference.render(context.job.scene, request, context.progress);
    summarise_errors(frame.image, result);
  });
  if (scene.failure) return frame;
  result.device = frame.device;
  result.wall_time_s = frame.wall_time_s;
  result.warnings = frame.warnings;
  add_metadata(frame, context.job.scene, request);
  result.image_file = context.relative("reference.exr");
  save_image(context, result.image_file, frame.image);
  result.picture_file = context.relative("reference.png");
  save_picture(context, result.picture_file, visibility_picture(frame.image));
  scene.reference = result;
  return frame;
}

void compare_renderers(const SceneContext& context, const Image& surfaces, const Image& reference,
                       SceneResult& scene) {
  const glm::dvec3& eye = context.job.scene.camera.eye_world;
  const double eye_world[3] = {eye.x, eye.y, eye.z};
  const ParityTolerance tolerance;
  Parity parity;
  scene.failure = guarded([&] { parity = compare_surfaces(surfaces, reference, eye_world, tolerance); });
  if (scene.failure) return;
  ParityNumbers numbers = parity_numbers(parity, tolerance.required_agreement);
  numbers.picture_file = context.relative("parity.png");
  save_picture(context, numbers.picture_file, parity_picture(parity));
  scene.parity = numbers;
}

void score_technique(const SceneContext& context, const Image& reference, TechniqueFrame& run) {
  TechniqueResult& result = run.result;
  const Image& image = run.frame.image;
  const std::string stem = file_name_of(result.label);
  Score score;
  result.failure = guarded([&] {
    score = score_image(image, reference, context.job.scene.camera.eye_world,
                        {context.plan.metrics, context.plan.limit_rmse, context.plan.maps});
  });
  if (result.failure) return;
  result.picture_file = context.relative(stem + ".png");
  save_picture(context, result.picture_file, visibility_picture(image));
  if (!score.error) return;
  result.error = score.error;
  result.judgement = score.judgement;
  result.similarity = score.similarity;
  if (score.maps) {
    result.maps_file = context.relative(stem + "-maps.exr");
    save_image(context, result.maps_file, *score.maps);
  }
  run.mask = score.mask;
  result.error_picture_file = context.relative(stem + "-error.png");
  const Picture picture = signed_error_picture(image, reference, score.mask);
  result.clipped_share = picture.clipped_share;
  save_picture(context, result.error_picture_file, picture);
  result.diagnosis = score.diagnosis;
  if (score.no_diagnosis) {
    result.warnings.push_back("the faults could not be told apart: " + score.no_diagnosis->message);
    return;
  }
  if (!score.diagnosis) return;
  result.fault_picture_file = context.relative(stem + "-faults.png");
  save_picture(context, result.fault_picture_file,
               fault_picture(score.fault_classes, image.width, image.height));
}

void compare_with_baseline(const SceneContext& context, const Image& reference,
                           std::span<TechniqueFrame> runs) {
  if (!context.plan.metrics.verdict) return;
  const std::string& wanted = context.plan.baseline;
  const auto baseline = std::ranges::find_if(runs, [&](const TechniqueFrame& run) {
    return run.result.error && (wanted.empty() || run.result.label == wanted);
  });
  if (baseline == runs.end()) return;
  const ScoredImage against = {baseline->frame.image, baseline->mask};
  for (TechniqueFrame& run : runs) {
    if (!run.result.error || &run == &*baseline) continue;
    run.result.judgement.verdict =
        judge_against({run.frame.image, run.mask}, against, baseline->result.label, reference);
  }
}

}  // namespace umbrameter
