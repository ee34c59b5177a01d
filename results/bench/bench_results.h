// SPDX-License-Identifier: Apache-2.0
#pragma once
// What a bench was asked and what it measured. Not here: the files (results/bench/bench_json.h).

#include "results/bench/claims.h"
#include "results/bench/truth_curve.h"
#include "results/measured.h"
#include "results/technique_run.h"
#include "results/timing_plan.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace umbrameter {

struct BenchRun {
  TechniqueRun technique;
  uint64_t seed = 1;
  std::optional<double> compares_per_pixel = {};  // as in RunCost
};

struct BenchPlan {
  std::string title;
  std::string doc;
  std::string file;  // of the study
  std::string quality;
  /// Samples and target are those that the reference renderer was made with; recorded.
  PictureQuality picture{.width_px = 480, .height_px = 270, .samples_per_pixel = 256};
  TimingPlan timing;
  std::vector<BenchRun> runs;
  std::vector<Claim> claims;
};

struct BenchScene {
  std::string name;    // full_name() of the study's
  std::string scene;   // as the study wrote it
  std::string camera;  // of the study; empty: the scene's own
  std::string title;
  std::string hash;
  std::string light;
  uint64_t triangles = 0;
  std::vector<std::string> warnings;
  std::optional<Failure> failure;  // of the truth: times stand, errors do not
  std::string reference_device;
  std::optional<ParityNumbers> parity;
  size_t scorable_pixels = 0,
         scored_pixels = 0;  // that the truth can score, and of them those with one surface
  std::vector<BenchEntry> entries;
  std::vector<ClaimResult> claims;  // those that speak of this scene
  std::optional<TruthCurve> truth;  // when it was asked for
};

struct BenchResults {
  std::string version;
  std::string commit;
  BenchPlan plan;
  std::vector<BenchScene> scenes;
  std::vector<Skip> skipped;
};

/// What must stand beside every time of a software rasteriser.
inline constexpr const char* kSoftwareNote = "software rasteriser: ratios are not a GPU's";

/// True when any time was taken on a software rasteriser.
bool is_software(const BenchResults& results);

/// Every failure, as "scene: message" or "scene, run: message".
std::vector<Failure> all_failures(const BenchResults& results);

/// What was scored; parity that does not hold is told here.
std::vector<MeasuredScene> measured_scenes(const BenchResults& results);

}  // namespace umbrameter
