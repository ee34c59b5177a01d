// SPDX-License-Identifier: Apache-2.0
#include "study/grid/bench.h"

#include "core/hash.h"
#include "core/version.h"
#include "lab/renamed_progress.h"
#include "lab/score.h"
#include "results/guard.h"
#include "scenes/instances.h"
#include "study/study_camera.h"

#include <fmt/format.h>

#include <algorithm>

namespace umbrameter {
namespace {

struct BenchContext {
  const StudyScene& job;
  const BenchPlan& plan;
  Renderers renderers;
  Progress& progress;
  const TruthPlan& truth;
};

/// The pictures of a scene's runs: all show the same surfaces.
struct Pictures {
  std::optional<Image> surfaces;
  std::vector<Image> visibility;  // by entry; one plane each
};

BenchScene describe(const StudyScene& job) {
  BenchScene scene;
  scene.name = full_name(job);
  scene.scene = job.name;
  scene.camera = job.camera;
  scene.title = job.scene.title;
  scene.hash = job.scene.hash;
  scene.light = to_text(job.scene.light().type);
  scene.triangles = count_shown_triangles(job.scene);
  scene.warnings = job.scene.warnings;
  return scene;
}

/// An entry for every run that supports the scene's light; the others join `skipped`.
std::vector<LabelledRequest> choose_runs(const BenchContext& context, BenchScene& scene,
                                         std::vector<Skip>& skipped) {
  std::vector<LabelledRequest> requests;
  for (const BenchRun& run : context.plan.runs) {
    const TechniqueRun& technique = run.technique;
    if (const auto reason = skip_reason(technique, context.job.scene)) {
      skipped.push_back({scene.name, technique.label, *reason});
      continue;
    }
    requests.push_back({technique.label, request_of(context.plan.picture, technique, run.seed)});
    BenchEntry entry;
    entry.label = technique.label;
    entry.technique = technique.id;
    entry.hash = technique.hash;
    entry.parameters = technique.parameters;
    entry.compares_per_pixel = run.compares_per_pixel;
    entry.seed = run.seed;
    scene.entries.push_back(std::move(entry));
  }
  return requests;
}

std::string hash_of_picture(const Image& visibility) {
  return Hasher().values(visibility.plane("visibility")).hex();
}

void take_result(TimedRun& run, BenchEntry& entry) {
  entry.failure = run.failure;
  if (entry.failure) return;
  entry.times = std::move(run.times);
  entry.time_ms = median_interval(frame_totals(entry.times));
  entry.parameters = run.frame.parameters;
  entry.memory_bytes = run.frame.memory_bytes;
  entry.device = run.frame.device;
  entry.is_software = run.frame.is_software;
  entry.timer = run.timer;
  entry.warnings = run.frame.warnings;
}

/// One full image a scene is kept, and the visibility of each run.
void keep_picture(Image& image, Image& visibility, std::optional<Image>& surfaces) {
  visibility = Image(image.width, image.height);
  if (auto known = image.planes.extract("known"); !known.empty()) visibility.planes.insert(std::move(known));
  const auto from = image.plane("visibility");
  std::ranges::copy(from, visibility.add_plane("visibility").begin());
  if (!surfaces) surfaces = std::move(image);
  image = Image();
}

Pictures time_runs(const BenchContext& context, BenchScene& scene, std::vector<Skip>& skipped) {
  Pictures pictures;
  const std::vector<LabelledRequest> requests = choose_runs(context, scene, skipped);
  pictures.visibility.resize(requests.size());
  std::vector<TimedRun> runs = render_interleaved(
      context.renderers.realtime, context.job.scene, requests, context.plan.timing, context.progress,
      [&](size_t i, Frame& frame) { keep_picture(frame.image, pictures.visibility[i], pictures.surfaces); });
  for (size_t i = 0; i < runs.size(); ++i) {
    take_result(runs[i], scene.entries[i]);
    if (!scene.entries[i].failure) scene.entries[i].picture_hash = hash_of_picture(pictures.visibility[i]);
  }
  return pictures;
}

/// Renders the truth and sets what follows from it: parity, and each run's error.
void score_runs(const BenchContext& context, const Pictures& pictures, BenchScene& scene) {
  const RenderRequest request = request_of(context.plan.picture);
  const glm::dvec3& eye = context.job.scene.camera.eye_world;
  const double eye_world[3] = {eye.x, eye.y, eye.z};
  Frame reference;
  Parity parity;
  const ParityTolerance tolerance;
  scene.failure = guarded([&] {
    reference = context.renderers.reference.render(context.job.scene, request, context.progress);
    parity = compare_surfaces(*pictures.surfaces, reference.image, eye_world, tolerance);
  });
  if (scene.failure) return;
  scene.reference_device = reference.device;
  scene.parity = parity_numbers(parity, tolerance.required_agreement);
  if (!parity.passes) return;
  const std::vector<uint8_t> mask = scored_mask(parity, reference.image);
  scene.scorable_pixels = static_cast<size_t>(std::ranges::count(scorable_mask(reference.image), 1));
  scene.scored_pixels = static_cast<size_t>(std::ranges::count(mask, 1));
  for (size_t i = 0; i < scene.entries.size(); ++i) {
    BenchEntry& entry = scene.entries[i];
    if (entry.failure) continue;
    entry.failure = guarded([&] {
      const VisibilityError error = measure_visibility_error(pictures.visibility[i], reference.image,
                                                             known_mask(mask, pictures.visibility[i]));
      entry.rmse = error.rmse;
      entry.bias = error.bias;
    });
  }
}

BenchScene bench_scene(const BenchContext& context, std::vector<Skip>& skipped) {
  BenchScene scene = describe(context.job);
  const Pictures pictures = time_runs(context, scene, skipped);
  if (pictures.surfaces) score_runs(context, pictures, scene);
  if (!context.truth.settings.empty() && !scene.failure)
    scene.failure = guarded([&] {
      const RenderRequest request = request_of(context.plan.picture);
      scene.truth = measure_truth(context.job.scene, request, context.truth, context.progress);
    });
  find_front(scene.entries);
  scene.claims = judge_claims(context.plan.claims, scene.scene, scene.entries);
  return scene;
}

}  // namespace

std::string full_name(const StudyScene& scene) {
  return full_name(scene.name, scene.camera);
}

bool is_software(const BenchResults& results) {
  return std::ranges::any_of(results.scenes, [](const BenchScene& scene) {
    return std::ranges::any_of(scene.entries, &BenchEntry::is_software);
  });
}

BenchResults run_bench(std::span<const StudyScene> scenes, const BenchPlan& plan, Renderers renderers,
                       Progress& progress, const BenchSceneDone& scene_done, const TruthPlan& truth) {
  BenchResults results;
  results.version = kVersion;
  results.commit = kCommit;
  results.plan = plan;
  for (const StudyScene& job : scenes) {
    const std::string prefix =
        fmt::format("{} ({} of {}), ", full_name(job), results.scenes.size() + 1, scenes.size());
    RenamedProgress renamed(progress, [&](std::string_view task) { return prefix + std::string(task); });
    results.scenes.push_back(bench_scene({job, plan, renderers, renamed, truth}, results.skipped));
    if (scene_done) scene_done(results.scenes.back());
  }
  return results;
}

std::vector<Failure> all_failures(const BenchResults& results) {
  std::vector<Failure> failures;
  for (const BenchScene& scene : results.scenes) {
    if (scene.failure) failures.push_back({scene.failure->kind, scene.name + ": " + scene.failure->message});
    for (const BenchEntry& entry : scene.entries) {
      if (!entry.failure) continue;
      failures.push_back(
          {entry.failure->kind, scene.name + ", " + entry.label + ": " + entry.failure->message});
    }
  }
  return failures;
}

std::vector<MeasuredScene> measured_scenes(const BenchResults& results) {
  std::vector<MeasuredScene> scenes;
  for (const BenchScene& scene : results.scenes) {
    MeasuredScene measured;
    measured.name = scene.name;
    measured.scorable_pixels = scene.scorable_pixels;
    measured.why_none = why_none(results.skipped, scene.name, scene.parity.has_value());
    const bool is_void = scene.parity && !scene.parity->passes;
    if (is_void) measured.why_none = "the renderers see other surfaces";
    measured.is_told = scene.failure.has_value();
    for (const BenchEntry& entry : scene.entries) {
      const bool is_scored = !entry.failure && scene.parity && !is_void;
      if (is_scored) measured.scored_pixels.emplace_back(entry.label, scene.scored_pixels);
      measured.is_told = measured.is_told || entry.failure.has_value();
    }
    scenes.push_back(std::move(measured));
  }
  return scenes;
}

}  // namespace umbrameter
