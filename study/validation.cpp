#include "study/validation.h"

#include "core/files.h"
#include "core/image_io.h"
#include "study/guard.h"
#include "study/metadata.h"
#include "study/pictures.h"
#include "study/score.h"
#include "study/timing.h"
#include "umbrameter_version.h"

#include <fmt/format.h>

#include <algorithm>

namespace umbrameter {
namespace {

/// Gives tasks longer names: "pcss" becomes "plate (2 of 13), pcss:taps=64".
class RenamedProgress final : public Progress {
 public:
  using Rename = std::function<std::string(std::string_view)>;
  RenamedProgress(Progress& inner, Rename rename) : inner_(inner), rename_(std::move(rename)) {}
  void begin(std::string_view task, uint64_t steps) override { inner_.begin(rename_(task), steps); }
  void advance(uint64_t steps) override { inner_.advance(steps); }
  void end() override { inner_.end(); }

 private:
  Progress& inner_;
  Rename rename_;
};

struct SceneContext {
  const SceneJob& job;
  const ValidationPlan& plan;
  Renderers renderers;
  std::filesystem::path folder;  // of all results
  Progress& progress;

  std::string relative(const std::string& file) const {
    return "images/" + file_name_of(job.name) + "/" + file;
  }
};

struct TechniqueFrame {
  TechniqueResult result;
  Frame frame;
};

RenderRequest request_of(const ValidationPlan& plan) {
  return {.width_px = plan.width_px,
          .height_px = plan.height_px,
          .seed = plan.seed,
          .technique = {},
          .parameters = {}};
}

SceneResult describe(const SceneJob& job) {
  const Scene& scene = job.scene;
  SceneResult result;
  result.name = job.name;
  result.title = scene.title;
  result.doc = scene.doc;
  result.hash = scene.hash;
  result.light_name = scene.light().name;
  result.light_type = to_text(scene.light().type);
  result.triangles = scene.triangles.size();
  result.warnings = scene.warnings;
  return result;
}

void save_image(const SceneContext& context, const std::string& file, const Image& image) {
  write_exr(context.folder / file, image);
}

void save_picture(const SceneContext& context, const std::string& file, const Picture& picture) {
  write_picture(context.folder / file, picture);
}

TechniqueFrame render_technique(const SceneContext& context, const TechniqueRun& run) {
  TechniqueFrame out;
  TechniqueResult& result = out.result;
  result.label = run.label;
  result.technique = run.id;
  result.title = run.title;
  result.hash = run.hash;
  result.parameters = run.parameters;
  RenderRequest request = request_of(context.plan);
  request.technique = run.technique;
  request.parameters = run.parameters;
  result.failure = guarded([&] {
    const TimingPlan timing{context.plan.timed_frames, context.plan.timing_budget_s};
    RenamedProgress progress(context.progress, [&](std::string_view) { return run.label; });
    out.frame = render_timed(context.renderers.realtime, context.job.scene, request, timing, progress);
  });
  if (result.failure) return out;
  result.parameters = out.frame.parameters;
  result.pass_times = out.frame.pass_times;
  result.timer = out.frame.timer;
  result.device = out.frame.device;
  result.memory_bytes = out.frame.memory_bytes;
  result.wall_time_s = out.frame.wall_time_s;
  result.warnings = out.frame.warnings;
  add_metadata(out.frame, context.job.scene, request);
  result.image_file = context.relative(file_name_of(run.label) + ".exr");
  save_image(context, result.image_file, out.frame.image);
  return out;
}

std::vector<TechniqueFrame> render_techniques(const SceneContext& context, std::vector<Skip>& skipped) {
  std::vector<TechniqueFrame> frames;
  const LightType light = context.job.scene.light().type;
  for (const TechniqueRun& run : context.plan.techniques) {
    if (std::find(run.lights.begin(), run.lights.end(), light) == run.lights.end()) {
      skipped.push_back(
          {context.job.name, run.label, fmt::format("does not support {} lights", to_text(light))});
      continue;
    }
    frames.push_back(render_technique(context, run));
  }
  return frames;
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
  result.failure =
      guarded([&] { score = score_image(image, reference, context.job.scene.camera.eye_world); });
  if (result.failure) return;
  result.picture_file = context.relative(stem + ".png");
  save_picture(context, result.picture_file, visibility_picture(image));
  if (!score.error) return;
  result.error = score.error;
  result.error_picture_file = context.relative(stem + "-error.png");
  const Picture picture = signed_error_picture(image, reference, score.mask);
  result.clipped_share = picture.clipped_share;
  save_picture(context, result.error_picture_file, picture);
}

SceneResult validate_scene(const SceneContext& context, std::vector<Skip>& skipped) {
  SceneResult scene = describe(context.job);
  create_folder((context.folder / context.relative("reference.exr")).parent_path());
  // Real time first: a shader that does not compile is found before the long wait for the reference.
  Frame surfaces;
  scene.failure = guarded([&] {
    surfaces =
        context.renderers.realtime.render(context.job.scene, request_of(context.plan), context.progress);
  });
  if (scene.failure) return scene;
  std::vector<TechniqueFrame> runs = render_techniques(context, skipped);
  const bool all_failed =
      !runs.empty() && std::all_of(runs.begin(), runs.end(),
                                   [](const TechniqueFrame& run) { return run.result.failure.has_value(); });
  Frame reference;
  if (!all_failed) reference = render_reference(context, scene);
  if (scene.reference) compare_renderers(context, surfaces.image, reference.image, scene);
  for (TechniqueFrame& run : runs) {
    const bool is_comparable = !run.result.failure && scene.parity && scene.parity->passes;
    if (is_comparable) score_technique(context, reference.image, run);
    scene.techniques.push_back(std::move(run.result));
  }
  return scene;
}

}  // namespace

Results run_validation(std::span<const SceneJob> scenes, const ValidationPlan& plan, Renderers renderers,
                       const std::filesystem::path& folder, Progress& progress, const SceneDone& scene_done) {
  Results results;
  results.version = UMBRAMETER_VERSION;
  results.commit = UMBRAMETER_COMMIT;
  results.quality = plan.quality;
  results.width_px = plan.width_px;
  results.height_px = plan.height_px;
  results.seed = plan.seed;
  results.samples_per_pixel = plan.samples_per_pixel;
  results.target_se = plan.target_se;
  for (const SceneJob& job : scenes) {
    const std::string prefix =
        fmt::format("{} ({} of {}), ", job.name, results.scenes.size() + 1, scenes.size());
    RenamedProgress renamed(progress, [&](std::string_view task) { return prefix + std::string(task); });
    results.scenes.push_back(validate_scene({job, plan, renderers, folder, renamed}, results.skipped));
    if (scene_done) scene_done(results.scenes.back());
  }
  return results;
}

}  // namespace umbrameter
