// SPDX-License-Identifier: Apache-2.0
#include "lab/scene_run.h"

#include "core/clock.h"
#include "core/files.h"
#include "core/guard.h"
#include "core/image_io.h"
#include "lab/score.h"
#include "lab/stored_truth.h"
#include "lab/technique_result.h"
#include "lab/timing.h"
#include "lab/verdicts.h"
#include "metrics/image/shadow_quantity.h"
#include "results/json/record.h"
#include "results/metadata.h"
#include "results/pictures/pictures.h"

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

void take_result(TimedRun& run, TechniqueFrame& out) {
  TechniqueResult& result = out.result;
  result.failure = run.failure;
  if (result.failure) return;
  take_frame(run.frame, result);
  take_times(run, result);
  out.frame = std::move(run.frame);
  result.measured_at = time_now();
}

void save_visibility(const SceneContext& context, TechniqueFrame& run) {
  run.result.picture_file = context.relative(file_name_of(run.result.label) + ".png");
  save_picture(context, run.result.picture_file, visibility_picture(run.frame.image));
}

/// Visibility and its error where the mask says.
void save_pictures(const SceneContext& context, const Image& reference, TechniqueFrame& run) {
  save_visibility(context, run);
  TechniqueResult& result = run.result;
  result.error_picture_file = context.relative(file_name_of(result.label) + "-error.png");
  const Picture picture = signed_error_picture(run.frame.image, reference, run.mask);
  result.clipped_share = picture.clipped_share;
  save_picture(context, result.error_picture_file, picture);
}

void save_visibility(const SceneContext& context, const Image& image, ReferenceResult& result) {
  result.picture_file = context.relative("reference.png");
  save_picture(context, result.picture_file, visibility_picture(image));
}

}  // namespace

std::string image_path(const std::string& scene, const std::string& file) {
  return "images/" + file_name_of(scene) + "/" + file;
}

std::string SceneContext::relative(const std::string& file) const {
  return image_path(name, file);
}

std::vector<TechniqueFrame> choose_runs(const ValidationPlan& plan, const SceneResult& scene, LightType light,
                                        std::vector<Skip>& skipped) {
  std::vector<TechniqueFrame> runs;
  for (const TechniqueRun& run : plan.techniques) {
    if (const auto reason = skip_reason(run, light, scene.light_name)) {
      skipped.push_back({scene.name, run.label, *reason});
      continue;
    }
    runs.push_back({run, describe(run), {}, {}, {}});
  }
  return runs;
}

void render_techniques(const SceneContext& context, std::span<TechniqueFrame> runs) {
  std::vector<TechniqueFrame*> missing;
  std::vector<LabelledRequest> requests;
  for (TechniqueFrame& run : runs) {
    if (run.result.is_reused) continue;
    const PictureQuality& picture = context.plan.picture;
    requests.push_back({run.result.label, request_of(picture, run.technique, picture.seed)});
    missing.push_back(&run);
  }
  const TimingPlan timing{context.plan.timed_frames, context.plan.timing_budget_s};
  std::vector<TimedRun> timed =
      render_interleaved(context.renderers.realtime, context.scene, requests, timing, context.progress);
  for (size_t i = 0; i < timed.size(); ++i) {
    TechniqueFrame& run = *missing[i];
    take_result(timed[i], run);
    if (run.result.failure) continue;
    add_metadata(run.frame, context.scene, requests[i].request);
    run.result.image_file = context.relative(file_name_of(run.result.label) + ".exr");
    save_image(context, run.result.image_file, run.frame.image);
  }
}

Image require_reference(const SceneContext& context, SceneResult& scene) {
  if (scene.reference) {
    Image image = read_image(context.folder / scene.reference->image_file);
    if (!scene.reference->picture_file.empty()) return image;
    save_visibility(context, image, *scene.reference);  // a sweep has no pictures
    return image;
  }
  RenderedTruth truth;
  scene.failure = guarded([&] {
    truth = render_truth(context.renderers.reference, context.scene, request_of(context.plan.picture),
                         context.progress);
  });
  if (scene.failure) return {};
  truth.result.measured_at = time_now();
  take_truth(context, truth.frame.image, std::move(truth.result), scene);
  return std::move(truth.frame.image);
}

void compare_renderers(const SceneContext& context, const Image& surfaces, const Image& reference,
                       SceneResult& scene) {
  const glm::dvec3& eye_world = context.scene.camera.eye_world;
  Parity parity;
  scene.failure = guarded([&] { parity = compare_surfaces(surfaces, reference, eye_world); });
  if (!scene.failure) take_parity(context, parity, scene);
}

void take_parity(const SceneContext& context, const Parity& parity, SceneResult& scene) {
  ParityNumbers numbers = parity_numbers(parity);
  numbers.picture_file = context.relative("parity.png");
  save_picture(context, numbers.picture_file, parity_picture(parity));
  scene.parity = numbers;
}

void take_truth(const SceneContext& context, const Image& image, ReferenceResult result, SceneResult& scene) {
  result.image_file = context.relative("reference.exr");
  save_image(context, result.image_file, image);
  save_visibility(context, image, result);
  scene.reference = std::move(result);
}

namespace {

void score_technique(const SceneContext& context, const Image& reference, TechniqueFrame& run,
                     SharedTruth& shared) {
  Score score;
  std::optional<Image> made;
  const Image* truth = &reference;
  run.result.failure = guarded([&] {
    truth = &truth_for(run.frame.image, reference, made);
    score = score_image(run.frame.image, *truth, context.scene.camera.eye_world,
                        {context.plan.metrics, context.plan.limit_rmse, context.plan.maps},
                        made ? nullptr : &shared);
  });
  if (!run.result.failure) take_score(context, *truth, std::move(score), run);
}

/// A picture equal to that of `twin`, which is scored: its scores are the same, and so are its maps.
void take_scores(const SceneContext& context, const TechniqueFrame& twin, TechniqueFrame& run) {
  const TechniqueResult& from = twin.result;
  TechniqueResult& result = run.result;
  const std::string stem = file_name_of(result.label);
  const auto copied = [&](const std::string& picture, const char* suffix) {
    if (picture.empty()) return std::string();
    const std::string file = context.relative(stem + suffix);
    write_file_atomically(context.folder / file, read_file(context.folder / picture));
    return file;
  };
  result.picture_file = copied(from.picture_file, ".png");
  result.error_picture_file = copied(from.error_picture_file, "-error.png");
  result.fault_picture_file = copied(from.fault_picture_file, "-faults.png");
  result.maps_file = copied(from.maps_file, "-maps.exr");
  static_cast<Measures&>(result) = from;
  result.judgement.verdict.reset();
  result.clipped_share = from.clipped_share;
  result.left_out.push_back(fmt::format(
      "scoring: the picture is pixel by pixel that of '{}' (saves {:.2g} s)", from.label, twin.scoring_s));
  run.mask = twin.mask;
}

/// The first scored run before `run` with the same picture.
const TechniqueFrame* twin_of(const ValidationPlan& plan, const TechniqueFrame& run,
                              std::span<const TechniqueFrame> earlier) {
  const auto found = std::ranges::find_if(earlier, [&](const TechniqueFrame& other) {
    const bool is_scored = !other.result.is_reused && other.result.error &&
                           other.result.diagnosis.has_value() == plan.metrics.diagnosis;
    const Image &one = run.frame.image, &two = other.frame.image;
    return is_scored && std::ranges::equal(one.plane("visibility"), two.plane("visibility")) &&
           quantity_of(one) == quantity_of(two) &&
           one.planes == two.planes;  // where the map's texels lie counts, too
  });
  return found == earlier.end() ? nullptr : &*found;
}

}  // namespace

void take_score(const SceneContext& context, const Image& reference, Score score, TechniqueFrame& run) {
  TechniqueResult& result = run.result;
  const Image& image = run.frame.image;
  const std::string stem = file_name_of(result.label);
  if (!score.error) return save_visibility(context, run);
  static_cast<Measures&>(result) = score;
  if (score.maps) {
    result.maps_file = context.relative(stem + "-maps.exr");
    save_image(context, result.maps_file, *score.maps);
  }
  run.mask = std::move(score.mask);
  save_pictures(context, reference, run);
  if (score.no_diagnosis) {
    result.warnings.push_back("the faults could not be told apart: " + score.no_diagnosis->message);
    return;
  }
  if (!score.diagnosis) return;
  result.fault_picture_file = context.relative(stem + "-faults.png");
  save_picture(context, result.fault_picture_file,
               fault_picture(score.fault_classes, image.width, image.height));
}

void score_techniques(const SceneContext& context, const Image& reference, std::span<TechniqueFrame> runs,
                      const RunDone& run_done) {
  SharedTruth shared;
  for (size_t i = 0; i < runs.size(); ++i) {
    TechniqueFrame& run = runs[i];
    if (run.result.is_reused || run.result.failure) continue;
    const Clock::time_point start = Clock::now();
    const TechniqueFrame* twin = context.plan.skip ? twin_of(context.plan, run, runs.first(i)) : nullptr;
    if (twin != nullptr) {
      take_scores(context, *twin, run);
    } else {
      score_technique(context, reference, run, shared);
    }
    run.scoring_s = seconds_since(start);
    run_done(run);
  }
}

void draw_swept(const SceneContext& context, const Image& reference, std::span<TechniqueFrame> runs) {
  for (TechniqueFrame& run : runs) {
    if (!run.lacks_pictures) continue;
    require_picture(context, reference, run);
    Image& image = run.frame.image;
    std::ranges::copy(reference.plane("primitive_id"), image.add_plane("primitive_id").begin());
    std::optional<Image> made;
    save_pictures(context, truth_for(image, reference, made), run);
  }
}

void require_picture(const SceneContext& context, const Image& reference, TechniqueFrame& run) {
  if (!run.mask.empty()) return;
  run.frame.image = read_image(context.folder / run.result.image_file);
  run.mask = stored_mask(run.frame.image);
  if (!run.mask.empty()) return;
  const glm::dvec3& eye_world = context.scene.camera.eye_world;
  run.mask = scored_mask(compare_surfaces(run.frame.image, reference, eye_world), reference);
}

TechniqueFrame* baseline_of(const ValidationPlan& plan, std::span<TechniqueFrame> runs) {
  if (!plan.metrics.verdict) return nullptr;
  const auto find = [&](std::string_view label) {
    return std::ranges::find_if(runs, [&](const TechniqueFrame& run) {
      return run.result.error && (label.empty() || run.result.label == label);
    });
  };
  auto baseline = find(plan.baseline.empty() ? "hard" : plan.baseline);
  if (baseline == runs.end() && plan.baseline.empty()) baseline = find({});
  return baseline == runs.end() ? nullptr : &*baseline;
}

void compare_with_baseline(const SceneContext& context, const Image& reference,
                           std::span<TechniqueFrame> runs) {
  TechniqueFrame* const baseline = baseline_of(context.plan, runs);
  if (baseline == nullptr) return;
  for (TechniqueFrame& run : runs) {
    if (!run.result.error || &run == baseline || run.has_verdict) continue;
    require_picture(context, reference, *baseline);
    require_picture(context, reference, run);
    run.result.judgement.verdict =
        judge_runs({run.frame.image, run.mask}, {baseline->frame.image, baseline->mask},
                   baseline->result.label, reference);
  }
}

}  // namespace umbrameter
