// SPDX-License-Identifier: Apache-2.0
#include "lab/validation_cache.h"

#include "core/hash.h"
#include "core/version.h"
#include "lab/stored_frames.h"
#include "lab/stored_runs.h"
#include "lab/stored_truth.h"
#include "lab/validated.h"
#include "results/json/causes_json.h"
#include "results/json/json_optional.h"
#include "results/json/json_parts.h"
#include "results/json/judgement_json.h"
#include "results/json/record.h"
#include "results/json/run_json.h"
#include "results/metadata.h"
#include "store/objects.h"

#include <array>

namespace umbrameter {
namespace {

using OrderedJson = nlohmann::ordered_json;
namespace fs = std::filesystem;

std::string unlit_key(const std::string& reference, const Makers& makers) {
  return Hasher().text("unlit").text(parity_key(reference, makers)).hex();
}

/// Whether causes are worth their cost depends on what else the scene has.
std::string skip_of_causes_key(const TechniqueFrame& run, std::span<const TechniqueFrame> runs) {
  Hasher hasher;
  hasher.text("skip of causes").text(run.key);
  for (const TechniqueFrame& other : runs) hasher.text(other.key);
  return hasher.hex();
}

constexpr const char* kUnlit = R"({"unlit": true})";

RecordHead head_of(const SceneSource& source, const ValidationPlan& plan, const std::string& measured_at,
                   double duration_s) {
  const SceneResult& scene = source.description;
  return {scene.name, {}, scene.hash, scene.light_type, plan.picture, kCommit, measured_at, duration_s};
}

/// A file name of a result, and what the file is called in images/<scene>/.
struct ImageSlot {
  std::string& name;
  std::string file;
};

std::array<ImageSlot, 5> slots_of(TechniqueResult& run) {
  const std::string stem = file_name_of(run.label);
  return {{{run.image_file, stem + ".exr"},
           {run.picture_file, stem + ".png"},
           {run.error_picture_file, stem + "-error.png"},
           {run.fault_picture_file, stem + "-faults.png"},
           {run.maps_file, stem + "-maps.exr"}}};
}

std::array<ImageSlot, 2> slots_of(ReferenceResult& truth) {
  return {{{truth.image_file, "reference.exr"}, {truth.picture_file, "reference.png"}}};
}

std::array<ImageSlot, 1> slots_of(ParityNumbers& parity) {
  return {{{parity.picture_file, "parity.png"}}};
}

/// Objects become files of `folder`.
template <class Part>
void place(const Store& store, const fs::path& folder, const std::string& scene, Part& part) {
  for (const ImageSlot& slot : slots_of(part)) {
    if (slot.name.empty()) continue;
    const std::string file = image_path(scene, slot.file);
    place_object(store.folder(), slot.name, folder / file);
    slot.name = file;
  }
}

/// `part` with files of `folder` kept as objects; the files become links to them.
template <class Part>
Part kept(Store& store, const fs::path& folder, Part part) {
  for (const ImageSlot& slot : slots_of(part)) {
    if (slot.name.empty()) continue;
    const fs::path file = folder / slot.name;
    slot.name = store.keep(file);
    place_object(store.folder(), slot.name, file);
  }
  return part;
}

bool is_final(const TechniqueResult& run) {
  return !run.failure || run.failure->kind == ErrorKind::input;
}

std::string key_of(const std::string& reference, const TechniqueFrame& run, const ValidationPlan& plan,
                   const Makers& makers) {
  return moved_run_key(run_key(reference, run.technique, plan.picture.seed, plan.metrics, makers),
                       plan.motion);
}

}  // namespace

std::optional<std::string> ValidationCache::find(const std::string& key) {
  return reuse_ ? store_.find(key) : std::nullopt;
}

std::string ValidationCache::reference_of(const SceneSource& source, const ValidationPlan& plan) const {
  return reference_key(source.description.hash, source.active_light, plan.picture, makers_, plan.skip);
}

void ValidationCache::find_results(const SceneSource& source, const ValidationPlan& plan,
                                   const fs::path& folder, SceneResult& scene,
                                   std::vector<TechniqueFrame>& runs) {
  const std::string reference = reference_of(source, plan);
  kept_.clear();
  for (TechniqueFrame& run : runs) {
    const std::string key = key_of(reference, run, plan, makers_);
    run.key = validated_run_key(key, plan);
    const auto json = find(run.key);
    auto record = json ? parse_run_record(*json) : std::nullopt;
    if (!record && reuse_) {
      record = find_swept(store_, key, plan);
      run.lacks_pictures = record.has_value();
      if (record) record->result.measured_at = record->head.started;
    }
    if (!record || !is_final(record->result)) continue;
    record->result.label = run.result.label;
    record->result.is_reused = true;
    run.result = std::move(record->result);
    place(store_.store(), folder, scene.name, run.result);
    if (!run.lacks_pictures) kept_.insert(run.key);
  }
  const auto truth = find(reference);
  if (auto record = truth ? parse_reference_record(*truth) : std::nullopt) {
    scene.reference = std::move(record->result);
    scene.reference->is_reused = true;
    if (!scene.reference->picture_file.empty()) kept_.insert(reference);  // a sweep's has none for people
    if (scene.reference->measured_at.empty()) scene.reference->measured_at = record->head.started;
    place(store_.store(), folder, scene.name, *scene.reference);
  }
  const std::string parity = parity_key(reference, makers_);
  scene.parity = read_json(find(parity), read_parity);
  if (!scene.parity) return;
  place(store_.store(), folder, scene.name, *scene.parity);
  kept_.insert(parity);
}

void ValidationCache::keep_truth(const SceneSource& source, const ValidationPlan& plan,
                                 const fs::path& folder, const SceneResult& scene) {
  const std::string key = reference_of(source, plan);
  if (!scene.reference || !kept_.insert(key).second) return;
  const ReferenceResult truth = kept(store_.store(), folder, *scene.reference);
  const RecordHead head = head_of(source, plan, truth.measured_at, truth.wall_time_s);
  store_.store().put({key, EntryKind::reference, to_json_text(ReferenceRecord{head, truth})});
}

void ValidationCache::keep_parity(const SceneSource& source, const ValidationPlan& plan,
                                  const fs::path& folder, const SceneResult& scene) {
  const std::string key = parity_key(reference_of(source, plan), makers_);
  if (!scene.parity || !kept_.insert(key).second) return;
  umbrameter::keep_parity(store_.store(), key, kept(store_.store(), folder, *scene.parity));
}

void ValidationCache::keep_surfaces(const SceneSource& source, const ValidationPlan& plan,
                                    const fs::path& folder, const Frame& surfaces) {
  const std::string key =
      frame_key(source.description.hash, source.active_light, request_of(plan.picture), {}, makers_);
  if (!plan.motion.empty() || store_.find(key)) return;
  keep_frame(store_.store(), key, surfaces, std::vector{keep_image(store_.store(), surfaces.image, folder)});
}

void ValidationCache::keep_run(const SceneSource& source, const ValidationPlan& plan, const fs::path& folder,
                               const SceneResult& scene, const TechniqueFrame& run) {
  if (!scene.reference || !scene.parity || !is_final(run.result) || !kept_.insert(run.key).second) return;
  const std::string reference = reference_of(source, plan);
  RunRecord record{head_of(source, plan, run.result.measured_at, run.result.wall_time_s + run.scoring_s),
                   reference,
                   {},
                   {},
                   scene.parity,
                   kept(store_.store(), folder, run.result),
                   {}};
  record.parity->picture_file.clear();  // stands in its own entry
  record.result.judgement.verdict.reset();
  record.result.fault_causes.reset();  // the same
  keep_record(store_.store(), run.key, record);
  note_validated(store_.store(), key_of(reference, run, plan, makers_), run.key);
  if (!plan.motion.empty() || run.result.failure || run.lacks_pictures) return;
  const RenderRequest request = request_of(plan.picture, run.technique, plan.picture.seed);
  keep_frame(store_.store(),
             frame_key(source.description.hash, source.active_light, request, run.technique.hash, makers_),
             run.frame, std::vector{record.result.image_file});
}

bool ValidationCache::find_verdict(const TechniqueFrame& baseline, TechniqueFrame& run) {
  const auto found = read_json(find(verdict_key(run.key, baseline.key)), [](const nlohmann::json& json) {
    return std::optional(read_judgement(json));
  });
  if (!found) return false;
  run.result.judgement.verdict = found->verdict;
  if (found->verdict) run.result.judgement.verdict->baseline = baseline.result.label;
  return true;
}

void ValidationCache::keep_verdict(const TechniqueFrame& baseline, const TechniqueFrame& run) {
  OrderedJson json;
  add_judgement({.significance = {}, .verdict = run.result.judgement.verdict, .limit = {}}, json);
  store_.store().put({verdict_key(run.key, baseline.key), EntryKind::verdict, json.dump()});
}

void ValidationCache::find_causes(const ValidationPlan& plan, TechniqueFrame& run,
                                  std::span<const TechniqueFrame> runs) {
  auto known = read_json(find(causes_key(run.key)), read_fault_causes);
  if (!known && plan.causes == CausesWanted::automatic)
    known = read_json(find(skip_of_causes_key(run, runs)), read_fault_causes);
  if (known) run.result.fault_causes = std::move(known);
}

void ValidationCache::keep_causes(const TechniqueFrame& run, std::span<const TechniqueFrame> runs) {
  const auto& causes = run.result.fault_causes;
  if (!causes) return;
  const std::string key = causes->skipped ? skip_of_causes_key(run, runs) : causes_key(run.key);
  store_.store().put({key, EntryKind::verdict, fault_causes_json(causes).dump()});
}

bool ValidationCache::is_unlit(const SceneSource& source, const ValidationPlan& plan) {
  return find(unlit_key(reference_of(source, plan), makers_)).has_value();
}

void ValidationCache::keep_unlit(const SceneSource& source, const ValidationPlan& plan) {
  store_.store().put({unlit_key(reference_of(source, plan), makers_), EntryKind::parity, kUnlit});
}

}  // namespace umbrameter
