// SPDX-License-Identifier: Apache-2.0
#pragma once
// What a validation found, as plain data: the model behind results.json (docs/results.md), the terminal table
// and the report. Not here: files (results/json/results_json.h) and how the numbers come about (lab/validation.h).

#include "core/guard.h"
#include "core/parameters.h"
#include "metrics/causes/fault_causes.h"
#include "metrics/diagnosis.h"
#include "metrics/error/lit_similarity.h"
#include "metrics/error/visibility_error.h"
#include "metrics/image/parity.h"
#include "metrics/judgement.h"
#include "metrics/statistics/frame_times.h"
#include "metrics/temporal/temporal.h"
#include "results/picture_quality.h"
#include "scenes/animation_time.h"

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace umbrameter {

/// Something that was left out on purpose. `technique` is empty when it is of the whole scene or its truth.
struct Skip {
  std::string scene;
  std::string technique;
  std::string reason;
  std::optional<double> saved_s = {};  // estimate (results/savings.h); absent when nothing tells
};

/// Parity without its per-pixel classes.
struct ParityNumbers {
  size_t covered = 0;
  size_t coverage_mismatch = 0;
  size_t surface_mismatch = 0;
  size_t irradiance_mismatch = 0;
  size_t same_primitive = 0;
  double median_relative_depth_error = 0.0;
  double agreement = 0.0;
  double required_agreement = 0.0;
  bool passes = false;
  std::string picture_file;
};

ParityNumbers parity_numbers(const Parity& parity,
                             double required_agreement = ParityTolerance{}.required_agreement);

struct ReferenceResult {
  std::string device;
  double wall_time_s = 0.0;
  double mean_visibility_se = 0.0;  // over covered pixels; 0 when there are none
  double max_visibility_se = 0.0;
  double mean_sample_count = 0.0;
  size_t scorable_pixels = 0;                // surfaces that the light can reach
  std::optional<double> model_gap_rmse;      // of S - V of the truth, below which no visibility can come
  std::optional<double> model_gap_lit_rmse;  // the same of the lit picture (metrics/error/lit_error.h)
  double proven_lit_share = 0.0;             // of the covered pixels: no caster between them and the light
  double proven_dark_share = 0.0;            // one triangle, or their own surface, hides all of the light
  std::vector<std::string> warnings;
  std::string measured_at;   // UTC
  bool is_reused = false;    // taken from the store by this process; not written
  std::string image_file;    // EXR; file names are relative to the results folder
  std::string picture_file;  // PNG
};

/// Over sequences of the scene (lab/temporal.h).
struct TemporalNumbers {
  int frames = 0;
  Flicker camera;                    // moving camera
  Popping light;                     // moving light
  std::optional<double> seed_noise;  // of the technique's seeds
};

/// What a picture got against the truth. `error` is absent where parity fails, and everything with it.
struct Measures {
  std::optional<VisibilityError> error;
  std::optional<double>
      lit_rmse;         // of the lit picture (metrics/error/lit_error.h); absent without halves of S
  Judgement judgement;  // empty without `error`
  std::optional<Diagnosis> diagnosis;      // absent without `error`, and when a warning says why
  std::optional<Similarity> similarity;    // when asked for
  std::map<std::string, double> measured;  // by key: rows of results/catalogue.h that have `measure`
};

/// One technique with one parameter set on one scene. `error` is absent when the run failed, when parity
/// voids the scene, or when the reference failed.
struct TechniqueResult : Measures {
  std::string label;      // unique in its scene
  std::string technique;  // id
  std::string title;
  std::string quantity = "visibility";  // what its picture is (metrics/image/shadow_quantity.h)
  std::string hash;                     // of the technique's manifest and shaders
  ParameterValues parameters;
  std::optional<Failure> failure;
  std::optional<TemporalNumbers> temporal;  // when asked for
  std::optional<FaultCauses> fault_causes;  // when asked for, and only of the worst runs unless of all
  double clipped_share = 0.0;               // of scored pixels, beyond the error picture's scale
  std::vector<PassTime> pass_times;
  std::string timer;
  std::string device;
  uint64_t memory_bytes = 0;
  double wall_time_s = 0.0;
  std::vector<std::string> warnings;
  std::vector<std::string> left_out;  // passes and textures that the parameters do not need
  int frames_before = 0;              // drawn first, whose history the picture holds
  std::string motion;                 // of those (scenes/motion.h); empty without
  std::string measured_at;            // UTC
  bool is_reused = false;             // taken from the store by this process; not written
  std::string image_file;
  std::string picture_file;
  std::string error_picture_file;
  std::string fault_picture_file;
  std::string maps_file;  // EXR of metrics/maps.h, when asked for
};

struct SceneResult {
  std::string name;
  std::string title;
  std::string doc;
  std::string hash;
  std::string light_name;
  std::string light_type;
  std::vector<AnimatedMesh> animated;  // as Scene's
  uint64_t triangles = 0;
  std::string quantity = "visibility";  // that runs were compared as (metrics/image/shadow_quantity.h)
  std::vector<std::string> warnings;
  std::optional<Failure> failure;  // the reference, the G-buffer or the comparison failed
  std::optional<ReferenceResult> reference;
  std::optional<ParityNumbers> parity;
  std::vector<TechniqueResult> techniques;
};

/// What this process did; not written.
struct WorkDone {
  size_t rendered = 0, reused = 0;  // runs
  size_t references_rendered = 0, references_reused = 0;
};

struct Results {
  std::string version;
  std::string commit;
  std::string quality;
  PictureQuality picture;
  std::vector<SceneResult> scenes;
  std::vector<Skip> skipped;
  WorkDone work;
};

/// Time of a whole frame: the entry "total". Absent when nothing was timed.
std::optional<PassTime> total_time(const std::vector<PassTime>& pass_times);

/// Root of a region's mse with its sign; absent for a region without pixels.
std::optional<double> region_rmse(const RegionError& region);

/// True when every scene that was compared passes parity.
bool parity_passes(const Results& results);

/// True when a technique's RMSE is above the limit for certain.
bool exceeds_limit(const Results& results);

/// Every failure, as "scene: message" or "scene, technique: message".
std::vector<Failure> all_failures(const Results& results);

}  // namespace umbrameter
