#include "study/validation.h"

#include "core/files.h"
#include "study/guard.h"
#include "study/renamed_progress.h"
#include "study/scene_run.h"
#include "study/temporal.h"
#include "umbrameter_version.h"

#include <fmt/format.h>

#include <algorithm>

namespace umbrameter {
namespace {

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

/// Sequences of the truth are made once a scene, and only when a run was scored.
void measure_sequences(const SceneContext& context, const Image& reference,
                       std::vector<TechniqueFrame>& runs) {
  if (std::none_of(runs.begin(), runs.end(), [](const auto& run) { return run.result.error.has_value(); }))
    return;
  const Sequence camera = render_sequence(context, Motion::camera, reference);
  const Sequence light = render_sequence(context, Motion::light, reference);
  for (TechniqueFrame& run : runs) {
    if (run.result.error) measure_temporal(context, camera, light, run);
  }
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
  }
  compare_with_baseline(context, reference.image, runs);
  if (context.plan.temporal_frames > 0) measure_sequences(context, reference.image, runs);
  for (TechniqueFrame& run : runs) scene.techniques.push_back(std::move(run.result));
  return scene;
}

}  // namespace

std::optional<std::string> skip_reason(const TechniqueRun& run, const Scene& scene) {
  const LightType light = scene.light().type;
  if (std::ranges::find(run.lights, light) != run.lights.end()) return std::nullopt;
  return fmt::format("does not support {} lights", to_text(light));
}

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
