// SPDX-License-Identifier: Apache-2.0
#include "study/grid/bench_cache.h"

#include "core/hash.h"
#include "lab/keep_score.h"
#include "lab/stored_runs.h"
#include "lab/technique_result.h"
#include "lab/validated.h"
#include "results/json/json_parts.h"
#include "results/json/run_json.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>

namespace umbrameter {
namespace {

using OrderedJson = nlohmann::ordered_json;

std::string times_key(const BenchPlan& plan, std::span<const KeptRun> runs) {
  Hasher hasher;
  hasher.text("times").number(plan.timing.wanted_frames).number(plan.timing.budget_s);
  for (const KeptRun& run : runs) hasher.text(run.key);
  return hasher.hex();
}

std::optional<RunRecord> find_known(BenchCache& cache, const std::string& key) {
  if (!cache.reuse || !cache.store.exists()) return std::nullopt;
  return find_run(cache.store.store(), key, {}).record;
}

/// What a record lacks.
OrderedJson times_json_of(const BenchEntry& entry) {
  return {{"picture_hash", entry.picture_hash},
          {"is_software", entry.is_software},
          {"passes", entry.times.passes},
          {"frames_ms", entry.times.frames_ms}};
}

void read_entry(const nlohmann::json& json, const RunRecord& record, BenchEntry& entry) {
  take_record(record, entry);
  entry.picture_hash = json.at("picture_hash");
  entry.is_software = json.at("is_software");
  entry.times = {json.at("passes"), json.at("frames_ms")};
  entry.time_ms = median_interval(frame_totals(entry.times));
}

void read_scene(const nlohmann::json& json, std::span<const KeptRun> runs, BenchScene& scene) {
  scene.reference_device = json.at("reference_device");
  scene.parity = read_parity(json.at("parity"));
  scene.scorable_pixels = json.at("scorable_pixels");
  scene.scored_pixels = json.at("scored_pixels");
  for (size_t i = 0; i < runs.size(); ++i)
    read_entry(json.at("runs").at(i), runs[i].record, scene.entries[i]);
}

}  // namespace

void take_record(const RunRecord& record, BenchEntry& entry) {
  const std::string label = entry.label;  // another study's run may be the same one
  static_cast<TechniqueResult&>(entry) = record.result;
  entry.label = label;
}

std::vector<KeptRun> find_runs(BenchCache& cache, const StudyScene& job, const BenchPlan& plan,
                               std::span<const BenchRun* const> runs) {
  const std::string reference = reference_key(job.scene, plan.picture, cache.makers);
  std::vector<KeptRun> found;
  std::map<uint64_t, std::string> baselines;  // by seed: the key of its first run, as a sweep has it
  for (const BenchRun* run : runs) {
    KeptRun kept;
    kept.run = run;
    kept.key = run_key(reference, run->technique, run->seed, {}, cache.makers);
    const auto [baseline, is_first] = baselines.try_emplace(run->seed, kept.key);
    if (auto record = find_known(cache, kept.key)) {
      kept.record = *std::move(record);
      kept.is_known = true;
    } else {
      kept.record = make_record(run->technique, make_head(job, plan.picture, run->seed), reference);
      if (!is_first) kept.record.baseline = baseline->second;
    }
    found.push_back(std::move(kept));
  }
  return found;
}

bool find_scene(BenchCache& cache, const BenchPlan& plan, std::span<const KeptRun> runs, BenchScene& scene) {
  if (runs.empty() || !std::ranges::all_of(runs, &KeptRun::is_known)) return false;
  BenchScene known = scene;
  const bool is_found =
      cache.answers.find(times_key(plan, runs), [&](const auto& json) { read_scene(json, runs, known); });
  if (is_found) scene = std::move(known);
  return is_found;
}

void keep_scored(BenchCache& cache, const Scene& scene, const Frame& frame, const Image& truth,
                 SharedTruth& shared, KeptRun& run) {
  RunRecord& record = run.record;
  take_frame(frame, record.result);
  Store& store = cache.store.store();
  keep_score({store, cache.scratch, cache.makers}, scene, frame.image, truth, {}, shared, record);
  keep_record(store, run.key, record);
}

void keep_scene(BenchCache& cache, const BenchPlan& plan, std::span<KeptRun> runs, const BenchScene& scene) {
  if (!scene.parity) return;
  OrderedJson entries = OrderedJson::array();
  for (size_t i = 0; i < runs.size(); ++i) {
    KeptRun& run = runs[i];
    entries.push_back(times_json_of(scene.entries[i]));
    if (run.is_known) continue;
    run.record.result.failure = scene.entries[i].failure;
    if (!run.record.parity) run.record.parity = scene.parity;
    keep_record(cache.store.store(), run.key, run.record);
  }
  cache.answers.keep(times_key(plan, runs), {{"reference_device", scene.reference_device},
                                             {"parity", parity_json(scene.parity)},
                                             {"scorable_pixels", scene.scorable_pixels},
                                             {"scored_pixels", scene.scored_pixels},
                                             {"runs", std::move(entries)}});
}

}  // namespace umbrameter
