// SPDX-License-Identifier: Apache-2.0
#include "study/grid/bench.h"

#include "core/guard.h"
#include "core/hash.h"
#include "core/version.h"
#include "lab/renamed_progress.h"
#include "lab/score.h"
#include "lab/technique_result.h"
#include "metrics/image/shadow_quantity.h"
#include "scenes/altered/study_camera.h"
#include "scenes/instances.h"
#include "study/grid/bench_cache.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace umbrameter {
namespace {

struct BenchContext {
  const StudyScene& job;
  const BenchPlan& plan;
  Renderers renderers;
  Progress& progress;
  const TruthPlan& truth;
  BenchCache* cache;  // may be null
};

/// The truth, rendered when the first run has a picture: a shader that does not compile is found before.
struct AskedTruth {
  bool is_asked = false;
  std::optional<Image> image;  // absent: it failed, or the renderers see other surfaces
  std::vector<uint8_t> mask;   // scored pixels
  SharedTruth shared;
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

/// The runs that support the scene's light, an entry each; the others join `skipped`.
std::vector<const BenchRun*> choose_runs(const BenchContext& context, BenchScene& scene,
                                         std::vector<Skip>& skipped) {
  std::vector<const BenchRun*> runs;
  for (const BenchRun& run : context.plan.runs) {
    const TechniqueRun& technique = run.technique;
    if (const auto reason = skip_reason(technique, context.job.scene)) {
      skipped.push_back({scene.name, technique.label, *reason});
      continue;
    }
    runs.push_back(&run);
    BenchEntry entry;
    static_cast<TechniqueResult&>(entry) = describe(technique);
    entry.compares_per_pixel = run.compares_per_pixel;
    entry.seed = run.seed;
    scene.entries.push_back(std::move(entry));
  }
  return runs;
}

void take_times(TimedRun& run, BenchEntry& entry) {
  if (run.failure) {
    entry.failure = run.failure;
    return;
  }
  entry.times = std::move(run.times);
  entry.time_ms = median_interval(frame_totals(entry.times));
  entry.parameters = run.frame.parameters;
  entry.memory_bytes = run.frame.memory_bytes;
  entry.device = run.frame.device;
  entry.is_software = run.frame.is_software;
  entry.timer = run.timer;
  entry.warnings = run.frame.warnings;
}

/// Renders the truth and sets what follows from it and the surfaces of a run: parity.
void ask_truth(const BenchContext& context, const Image& surfaces, AskedTruth& truth, BenchScene& scene) {
  truth.is_asked = true;
  const glm::dvec3& eye_world = context.job.scene.camera.eye_world;
  scene.failure = guarded([&] {
    Frame frame = context.renderers.reference.render(context.job.scene, request_of(context.plan.picture),
                                                     context.progress);
    const Parity parity = compare_surfaces(surfaces, frame.image, eye_world);
    scene.reference_device = frame.device;
    scene.parity = parity_numbers(parity);
    scene.scorable_pixels = static_cast<size_t>(std::ranges::count(scorable_mask(frame.image), 1));
    if (!parity.passes) return;
    truth.mask = scored_mask(parity, frame.image);
    scene.scored_pixels = static_cast<size_t>(std::ranges::count(truth.mask, 1));
    truth.image = std::move(frame.image);
  });
}

/// A run's first picture. `kept` is null without a memory.
void take_first_frame(const BenchContext& context, Frame& frame, KeptRun* kept, AskedTruth& truth,
                      BenchScene& scene, BenchEntry& entry) {
  entry.picture_hash = Hasher().values(std::as_const(frame.image).plane("visibility")).hex();
  if (!truth.is_asked) ask_truth(context, frame.image, truth, scene);
  entry.failure = guarded([&] {
    take_frame(frame, entry);
    if (kept != nullptr && kept->is_known) return take_record(kept->record, entry);
    if (!truth.image) return;
    if (kept != nullptr) {
      keep_scored(*context.cache, context.job.scene, frame, *truth.image, truth.shared, *kept);
      return take_record(kept->record, entry);
    }
    std::optional<Image> made;
    const Image& asked = truth_for(frame.image, *truth.image, made);
    entry.error = measure_visibility_error(frame.image, asked, known_mask(truth.mask, frame.image));
  });
  frame.image = Image();
}

void measure(const BenchContext& context, std::span<const BenchRun* const> runs, std::span<KeptRun> kept,
             BenchScene& scene) {
  std::vector<LabelledRequest> requests;
  for (const BenchRun* run : runs) {
    const TechniqueRun& technique = run->technique;
    requests.push_back({technique.label, request_of(context.plan.picture, technique, run->seed)});
  }
  AskedTruth truth;
  std::vector<TimedRun> timed = render_interleaved(
      context.renderers.realtime, context.job.scene, requests, context.plan.timing, context.progress,
      [&](size_t i, Frame& frame) {
        take_first_frame(context, frame, kept.empty() ? nullptr : &kept[i], truth, scene, scene.entries[i]);
      });
  for (size_t i = 0; i < runs.size(); ++i) {
    if (!kept.empty() && !kept[i].is_known && !timed[i].failure) take_times(timed[i], kept[i].record.result);
    take_times(timed[i], scene.entries[i]);
  }
}

/// Measured now, or known.
void measure_or_recall(const BenchContext& context, std::span<const BenchRun* const> runs, BenchScene& scene,
                       std::vector<Skip>& skipped) {
  if (context.cache == nullptr) return measure(context, runs, {}, scene);
  std::vector<KeptRun> kept = find_runs(*context.cache, context.job, context.plan, runs);
  if (find_scene(*context.cache, context.plan, kept, scene)) {
    double saved_s = 0.0;
    for (const KeptRun& run : kept) saved_s += run.record.head.duration_s;
    skipped.push_back({scene.name, "", "its runs and their times are stored", saved_s});
    return;
  }
  measure(context, runs, kept, scene);
  keep_scene(*context.cache, context.plan, kept, scene);
}

BenchScene bench_scene(const BenchContext& context, std::vector<Skip>& skipped) {
  BenchScene scene = describe(context.job);
  const std::vector<const BenchRun*> runs = choose_runs(context, scene, skipped);
  measure_or_recall(context, runs, scene, skipped);
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

RecordHead make_head(const StudyScene& scene, PictureQuality picture, uint64_t seed) {
  picture.seed = seed;
  RecordHead head = make_head(scene.name, scene.scene, picture);
  head.camera = scene.camera;
  return head;
}

BenchResults run_bench(std::span<const StudyScene> scenes, const BenchPlan& plan, Renderers renderers,
                       Progress& progress, const BenchSceneDone& scene_done, const TruthPlan& truth,
                       BenchCache* cache) {
  BenchResults results;
  results.version = kVersion;
  results.commit = kCommit;
  results.plan = plan;
  for (const StudyScene& job : scenes) {
    const std::string prefix =
        fmt::format("{} ({} of {}), ", full_name(job), results.scenes.size() + 1, scenes.size());
    RenamedProgress renamed(progress, [&](std::string_view task) { return prefix + std::string(task); });
    results.scenes.push_back(bench_scene({job, plan, renderers, renamed, truth, cache}, results.skipped));
    if (scene_done) scene_done(results.scenes.back());
  }
  return results;
}

}  // namespace umbrameter
