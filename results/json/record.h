// SPDX-License-Identifier: Apache-2.0
#pragma once
// What the store holds of a run and of a truth. Not here: under which key (lab/keys.h).

#include "results/picture_quality.h"
#include "results/results.h"
#include "scenes/scene.h"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace umbrameter {

/// What a stored result is of, and when it was made. Times are UTC: "2026-01-31T12:00:00.000Z".
struct RecordHead {
  std::string scene;
  std::string camera;  // of the study; empty: the scene's own
  std::string scene_hash;
  std::string light;       // type
  PictureQuality picture;  // of a run: with its seed
  std::string commit;
  std::string started;
  double duration_s = 0.0;
};

/// `result.image_file` names an object of the store with lab/verdicts.h's planes: the truth's image has the rest.
struct RunRecord {
  RecordHead head;
  std::string reference;  // key of the truth
  std::string baseline;   // key of the scene's first run of that seed, which it is compared with; empty: none
  std::vector<PassTime> baseline_times;  // of that run, drawn in turn with this one; empty without times
  std::optional<ParityNumbers> parity;
  TechniqueResult result;
  std::string key;  // of its entry, as lab/stored_runs.h found it; not written
};

struct ReferenceRecord {
  RecordHead head;
  ReferenceResult result;
};

/// Of the scene from its own camera, started now.
RecordHead make_head(const std::string& name, const Scene& scene, const PictureQuality& picture);

/// "ok", "failed", or "void": the renderers see different surfaces.
std::string status_of(const RunRecord& record);

std::string to_json_text(const RunRecord& record);
std::string to_json_text(const ReferenceRecord& record);

/// Absent for what another version wrote.
std::optional<RunRecord> parse_run_record(std::string_view json);
std::optional<ReferenceRecord> parse_reference_record(std::string_view json);

/// The time of day now, as records have it.
std::string time_now();

}  // namespace umbrameter
