// SPDX-License-Identifier: Apache-2.0
#pragma once
// Time against error: every run of a study on every scene, frames timed in turn, pictures scored against one truth a
// scene, what paper claims become of it. Sees only Renderer&.

#include "lab/answers.h"
#include "lab/keys.h"
#include "lab/timing.h"
#include "lab/truth_curve.h"
#include "lab/validation.h"
#include "results/bench/bench_results.h"
#include "results/json/record.h"

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace umbrameter {

/// Where a bench finds and leaves runs with their scores, as a sweep does, and the times of each scene's runs.
struct BenchCache {
  LazyStore& store;
  Answers& answers;
  Makers makers;
  bool reuse = true;
  std::filesystem::path scratch;  // an existing folder for files in the making
};

/// A scene of a study from one of its cameras.
struct StudyScene {
  std::string name;  // as the study wrote it
  Scene scene;
  std::string camera = {};  // of the study; empty: the scene's own
};

/// Of the scene from this camera, started now.
RecordHead make_head(const StudyScene& scene, PictureQuality picture, uint64_t seed);

/// As in scenes/altered/study_camera.h.
std::string full_name(const StudyScene& scene);

using BenchSceneDone = std::function<void(const BenchScene&)>;

/// Runs everything; a run that throws is recorded and the rest goes on (Error{cancelled} passes through). `truth` may be
/// empty. With `memory` a scene whose runs were all timed in turn before is not rendered; else all are timed, and those without
/// a score are scored.
BenchResults run_bench(std::span<const StudyScene> scenes, const BenchPlan& plan, Renderers renderers,
                       Progress& progress, const BenchSceneDone& scene_done = {}, const TruthPlan& truth = {},
                       BenchCache* cache = nullptr);

}  // namespace umbrameter
