// SPDX-License-Identifier: Apache-2.0
#include "lab/validated.h"

#include "core/image_io.h"
#include "lab/keys.h"
#include "lab/stored_runs.h"
#include "metrics/image/parity.h"

#include <nlohmann/json.hpp>

namespace umbrameter {
namespace {

constexpr double kSpentShare =
    0.2;  // of the budget: its first frame, by which the others are counted, is the slowest

/// What a validation keeps of it; absent for failures and for runs that were not comparable.
std::optional<RunRecord> find_validated(Store& store, const std::string& run) {
  const auto note = store.find(validated_note_key(run));
  const auto parsed = note ? nlohmann::json::parse(*note, nullptr, false) : nlohmann::json();
  const auto key = parsed.find("run");
  if (!parsed.is_object() || key == parsed.end() || !key->is_string()) return std::nullopt;
  auto record = find_record(store, key->get<std::string>());
  if (!record || record->result.failure || !record->result.error) return std::nullopt;
  return record;
}

/// Empty if nothing is.
std::string lack_of(const std::optional<RunRecord>& record, const std::optional<TimingPlan>& timing) {
  if (!record) return "not stored";
  const auto& failure = record->result.failure;
  if (failure) return failure->kind == ErrorKind::input ? "" : "failed before: " + failure->message;
  if (!timing || has_enough_frames(record->result, *timing)) return "";
  return record->result.pass_times.empty() ? "stored without times" : "stored with fewer frames";
}

}  // namespace

bool has_enough_frames(const TechniqueResult& run, const TimingPlan& timing) {
  if (timing.wanted_frames == 0) return true;
  const std::optional<PassTime> total = total_time(run.pass_times);
  if (!total) return false;
  const double spent_s = 1e-3 * total->median_ms * total->frames;
  return total->frames >= timing.wanted_frames || spent_s >= kSpentShare * timing.budget_s;
}

std::optional<RunRecord> find_swept(LazyStore& store, const std::string& run, const ValidationPlan& plan) {
  if (plan.maps || plan.temporal_frames > 0 || plan.limit_rmse) return std::nullopt;
  if (!store.exists()) return std::nullopt;
  auto record = find_record(store.store(), run);
  if (!record || record->result.failure || !record->result.error) return std::nullopt;
  const bool lacks_faults = record->result.diagnosis && record->result.fault_picture_file.empty();
  if (lacks_faults || !has_enough_frames(record->result, {plan.timed_frames, plan.timing_budget_s}))
    return std::nullopt;
  return record;
}

void note_validated(Store& store, const std::string& run, const std::string& validated) {
  store.put({validated_note_key(run), EntryKind::verdict, nlohmann::json{{"run", validated}}.dump()});
}

StoredRun find_run(Store& store, const std::string& run, const std::optional<TimingPlan>& timing) {
  StoredRun found{find_record(store, run), false, {}};
  found.lack = lack_of(found.record, timing);
  if (found.lack.empty()) return found;
  auto validated = find_validated(store, run);
  if (validated && lack_of(validated, timing).empty()) return {std::move(validated), true, {}};
  found.record.reset();
  return found;
}

StoredPicture swept_picture(const Store& store, const RunRecord& validated, const Image& truth,
                            const Camera& camera) {
  const glm::dvec3& eye_world = camera.eye_world;
  const Image image = read_image(store.path_of(validated.result.image_file));
  std::vector<uint8_t> mask = stored_mask(image);
  if (mask.empty()) mask = scored_mask(compare_surfaces(image, truth, eye_world), truth);
  return {picture_to_store(image, mask), std::move(mask)};
}

RunRecord swept(RunRecord validated, const std::string& label) {
  TechniqueResult& run = validated.result;
  run.label = label;
  run.temporal.reset();
  run.judgement.limit.reset();
  for (std::string* file : {&run.image_file, &run.picture_file, &run.error_picture_file, &run.maps_file})
    file->clear();
  return validated;
}

}  // namespace umbrameter
