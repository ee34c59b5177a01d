// SPDX-License-Identifier: Apache-2.0
#include "lab/validation.h"

#include "core/files.h"
#include "core/guard.h"
#include "core/version.h"
#include "lab/history.h"
#include "lab/renamed_progress.h"
#include "lab/run_causes.h"
#include "lab/scene_run.h"
#include "lab/temporal.h"
#include "lab/validation_cache.h"
#include "results/savings.h"
#include "scenes/instances.h"

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
  result.animated = scene.animated;
  result.triangles = count_shown_triangles(scene);
  result.warnings = scene.warnings;
  return result;
}

/// What every step of a scene's validation needs, before the scene is loaded.
struct SceneWork {
  const SceneSource& source;
  const ValidationPlan& plan;
  Renderers renderers;
  const std::filesystem::path& folder;
  Progress& progress;
  ValidationCache* cache;  // may be null
};

bool is_missing(const TechniqueFrame& run) {
  return !run.result.is_reused || run.lacks_pictures;
}

/// Sequences of the truth are made once a scene, and only when a run was scored.
void measure_sequences(const SceneContext& context, const Image& reference, std::vector<TechniqueFrame>& runs,
                       const RunDone& run_done) {
  const auto is_wanted = [](const TechniqueFrame& run) { return is_missing(run) && run.result.error; };
  if (std::ranges::none_of(runs, is_wanted)) return;
  const Sequence camera = render_sequence(context, "pan", reference);
  const Sequence light = render_sequence(context, "light", reference);
  for (TechniqueFrame& run : runs) {
    if (!is_wanted(run)) continue;
    measure_temporal(context, camera, light, run);
    run_done(run);
  }
}

void measure_histories(const SceneContext& context, const Image& reference,
                       std::vector<TechniqueFrame>& runs) {
  for (TechniqueFrame& run : runs) {
    if (!run.result.is_reused && run.result.error) measure_history(context, reference, run);
  }
}

std::shared_ptr<const Scene> in_motion(const std::shared_ptr<const Scene>& scene, const std::string& motion) {
  if (motion.empty()) return scene;
  auto moved = std::make_shared<Scene>(*scene);
  moved->motion = standard_motion(motion, *scene);
  return moved;
}

void skip_unlit(const SceneWork& work, std::vector<TechniqueFrame>& runs, std::vector<Skip>& skipped) {
  runs.clear();
  skipped.push_back({work.source.description.name, "", "the light reaches nothing in the picture"});
}

bool is_unlit(const Image& surfaces) {
  const auto irradiance = surfaces.plane("unshadowed_irradiance");
  return std::ranges::none_of(irradiance, [](float e) { return e > 0.0f; });
}

/// Sets all verdicts that are known; whether that is all of them.
bool find_verdicts(const SceneWork& work, std::vector<TechniqueFrame>& runs) {
  const TechniqueFrame* const baseline = baseline_of(work.plan, runs);
  if (baseline == nullptr) return true;
  bool is_complete = true;
  for (TechniqueFrame& run : runs) {
    if (!run.result.error || &run == baseline) continue;
    run.has_verdict = work.cache->find_verdict(*baseline, run);
    is_complete = is_complete && run.has_verdict;
  }
  return is_complete;
}

/// Sets all causes that are known; whether that is all that are wanted.
bool find_causes(const SceneWork& work, std::vector<TechniqueFrame>& runs) {
  bool is_complete = true;
  for (TechniqueFrame* run : runs_with_wanted_causes(work.plan, runs)) {
    work.cache->find_causes(work.plan, *run, runs);
    is_complete = is_complete && run->result.fault_causes;
  }
  return is_complete;
}

/// Sets what is known; whether that is everything.
bool find_results(const SceneWork& work, SceneResult& scene, std::vector<TechniqueFrame>& runs,
                  std::vector<Skip>& skipped) {
  if (work.cache == nullptr) return false;
  work.cache->find_results(work.source, work.plan, work.folder, scene, runs);
  if (work.plan.skip && work.cache->is_unlit(work.source, work.plan)) {
    skip_unlit(work, runs, skipped);
    return true;
  }
  const bool has_truth = scene.reference && !scene.reference->picture_file.empty() && scene.parity;
  const bool has_runs = find_verdicts(work, runs) && std::ranges::none_of(runs, is_missing);
  return has_truth && has_runs && find_causes(work, runs);
}

void keep_verdicts(const SceneWork& work, std::vector<TechniqueFrame>& runs) {
  const TechniqueFrame* const baseline = baseline_of(work.plan, runs);
  if (baseline == nullptr) return;
  for (const TechniqueFrame& run : runs) {
    if (run.result.error && &run != baseline && !run.has_verdict) work.cache->keep_verdict(*baseline, run);
  }
}

/// Renders and scores what is not known yet.
void measure(const SceneWork& work, SceneResult& scene, std::vector<TechniqueFrame>& runs,
             std::vector<Skip>& skipped) {
  const auto loaded = in_motion(work.source.load(), work.plan.motion);
  const SceneContext context{scene.name, *loaded, work.plan, work.renderers, work.folder, work.progress};
  // Real time first: a shader that does not compile is found before the long wait for the reference.
  Frame surfaces;
  scene.failure = guarded([&] {
    if (scene.parity) return;
    surfaces = work.renderers.realtime.render(*loaded, request_of(work.plan.picture), work.progress);
  });
  if (scene.failure) return runs.clear();
  if (!scene.parity && work.plan.skip && is_unlit(surfaces.image)) {
    if (work.cache != nullptr) work.cache->keep_unlit(work.source, work.plan);
    return skip_unlit(work, runs, skipped);
  }
  render_techniques(context, runs);
  const bool all_failed = !runs.empty() && std::ranges::all_of(runs, [](const TechniqueFrame& run) {
    return run.result.failure.has_value();
  });
  Image reference;
  if (!all_failed) reference = require_reference(context, scene);
  if (work.cache != nullptr) work.cache->keep_truth(work.source, work.plan, work.folder, scene);
  if (work.cache != nullptr && scene.reference && !surfaces.image.planes.empty())
    work.cache->keep_surfaces(work.source, work.plan, work.folder, surfaces);
  if (scene.reference && !scene.parity && !all_failed)
    compare_renderers(context, surfaces.image, reference, scene);
  if (work.cache != nullptr) work.cache->keep_parity(work.source, work.plan, work.folder, scene);
  const bool has_sequences = work.plan.temporal_frames > 0;
  const RunDone keep = [&](TechniqueFrame& run) {
    if (work.cache != nullptr) work.cache->keep_run(work.source, work.plan, work.folder, scene, run);
  };
  if (scene.parity && scene.parity->passes) {
    const bool is_complete = !has_sequences && work.plan.motion.empty();  // with its score
    score_techniques(
        context, reference, runs, is_complete ? keep : [](TechniqueFrame&) {});
    draw_swept(context, reference, runs);
  }
  if (work.cache != nullptr) find_verdicts(work, runs);
  compare_with_baseline(context, reference, runs);
  if (work.cache != nullptr) keep_verdicts(work, runs);
  if (!work.plan.motion.empty()) measure_histories(context, reference, runs);
  if (has_sequences) measure_sequences(context, reference, runs, keep);
  std::ranges::for_each(runs, keep);
  if (work.cache != nullptr) find_causes(work, runs);
  find_run_causes(context, reference, scene, runs, [&](const TechniqueFrame& run) {
    if (work.cache != nullptr) work.cache->keep_causes(run, runs);
  });
}

void count(const SceneResult& scene, WorkDone& work) {
  if (scene.reference) ++(scene.reference->is_reused ? work.references_reused : work.references_rendered);
  for (const TechniqueResult& run : scene.techniques) ++(run.is_reused ? work.reused : work.rendered);
}

SceneResult validate_scene(const SceneWork& work, Results& results) {
  SceneResult scene = work.source.description;
  create_folder((work.folder / image_path(scene.name, "reference.exr")).parent_path());
  std::vector<TechniqueFrame> runs = choose_runs(work.plan, scene, work.source.light, results.skipped);
  if (!find_results(work, scene, runs, results.skipped)) measure(work, scene, runs, results.skipped);
  for (TechniqueFrame& run : runs) scene.techniques.push_back(std::move(run.result));
  count(scene, results.work);
  return scene;
}

}  // namespace

SceneSource source_of(const SceneJob& job) {
  const std::shared_ptr<const Scene> borrowed(&job.scene, [](const Scene*) {});
  return {describe(job), job.scene.light().type, job.scene.active_light, job.scene.side_files,
          [borrowed] { return borrowed; }};
}

std::optional<std::string> skip_reason(const TechniqueRun& run, LightType light,
                                       const std::string& light_name) {
  if (!run.only_light.empty() && run.only_light != light_name)
    return fmt::format("has values for light '{}' alone", run.only_light);
  if (std::ranges::find(run.lights, light) != run.lights.end()) return std::nullopt;
  return fmt::format("does not support {} lights", to_text(light));
}

std::optional<std::string> skip_reason(const TechniqueRun& run, const Scene& scene) {
  return skip_reason(run, scene.light().type, scene.light().name);
}

Results run_validation(std::span<const SceneJob> scenes, const ValidationPlan& plan, Renderers renderers,
                       const std::filesystem::path& folder, Progress& progress, const SceneDone& scene_done) {
  std::vector<SceneSource> sources;
  for (const SceneJob& job : scenes) sources.push_back(source_of(job));
  return run_validation(sources, plan, renderers, folder, progress, scene_done, nullptr);
}

Results run_validation(std::span<const SceneSource> scenes, const ValidationPlan& plan, Renderers renderers,
                       const std::filesystem::path& folder, Progress& progress, const SceneDone& scene_done,
                       ValidationCache* cache) {
  Results results;
  results.version = kVersion;
  results.commit = kCommit;
  results.quality = plan.quality;
  results.picture = plan.picture;
  for (const SceneSource& source : scenes) {
    const std::string prefix =
        fmt::format("{} ({} of {}), ", source.description.name, results.scenes.size() + 1, scenes.size());
    RenamedProgress renamed(progress, [&](std::string_view task) { return prefix + std::string(task); });
    results.scenes.push_back(validate_scene({source, plan, renderers, folder, renamed, cache}, results));
    if (scene_done) scene_done(results.scenes.back());
  }
  add_savings(results);
  return results;
}

}  // namespace umbrameter
