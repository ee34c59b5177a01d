// SPDX-License-Identifier: Apache-2.0
#include "lab/stored_results.h"

#include "lab/stored_runs.h"
#include "lab/verdicts.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>
#include <tuple>

namespace umbrameter {
namespace {

/// What differs between the runs of a store beside scene and technique; a scene's name says only that.
struct Variety {
  std::set<uint64_t> seeds;
  std::set<std::string> qualities;
};

std::string quality_text(const PictureQuality& picture) {
  return fmt::format("{} x {} px, {} samples per pixel", picture.width_px, picture.height_px,
                     picture.samples_per_pixel);
}

Variety variety_of(const std::vector<RunRecord>& runs) {
  Variety variety;
  for (const RunRecord& run : runs) {
    variety.seeds.insert(run.head.picture.seed);
    variety.qualities.insert(quality_text(run.head.picture));
  }
  return variety;
}

std::string scene_name(const RecordHead& head, const Variety& variety) {
  std::string name = head.scene;
  if (!head.camera.empty()) name += ", " + head.camera;
  if (variety.qualities.size() > 1) name += ", " + quality_text(head.picture);
  if (variety.seeds.size() > 1) name += fmt::format(", seed {}", head.picture.seed);
  return name;
}

SceneResult describe_scene(Store& store, const RunRecord& run, const Variety& variety) {
  SceneResult scene;
  scene.name = scene_name(run.head, variety);
  scene.title = run.head.scene;
  scene.hash = run.head.scene_hash;
  scene.light_type = run.head.light;
  scene.parity = run.parity;
  if (scene.parity) scene.parity->picture_file.clear();  // a validation's, under an entry of its own
  const auto json = store.find(run.reference);
  if (auto truth = json ? parse_reference_record(*json) : std::nullopt) {
    scene.reference = std::move(truth->result);
    scene.reference->measured_at = truth->head.started;
  }
  return scene;
}

/// A label is there once in a scene: runs that share one are told apart by a number.
void make_labels_unique(std::vector<TechniqueResult>& runs) {
  std::map<std::string, size_t> counts;
  for (TechniqueResult& run : runs) {
    const size_t count = ++counts[run.label];
    if (count > 1) run.label += fmt::format(" #{}", count);
  }
}

}  // namespace

std::optional<Results> stored_results(Store& store) {
  std::vector<RunRecord> runs = stored_runs(store, false).runs;
  if (runs.empty()) return std::nullopt;
  judge_runs(store, runs, "");
  const Variety variety = variety_of(runs);
  Results results;
  results.commit = runs.front().head.commit;
  results.picture = runs.front().head.picture;
  std::map<std::tuple<std::string, uint64_t, std::string, std::string>, size_t> scene_of_truth;
  for (RunRecord& run : runs) {
    const auto key = std::tuple(run.reference, run.head.picture.seed, run.head.scene, run.head.camera);
    const auto [found, is_new] = scene_of_truth.emplace(key, results.scenes.size());
    if (is_new) results.scenes.push_back(describe_scene(store, run, variety));
    run.result.measured_at = run.head.started;
    results.scenes[found->second].techniques.push_back(std::move(run.result));
  }
  for (SceneResult& scene : results.scenes) make_labels_unique(scene.techniques);
  return results;
}

}  // namespace umbrameter
