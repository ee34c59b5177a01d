// SPDX-License-Identifier: Apache-2.0
#pragma once
// Scenes x techniques: render the truth once a scene, gate on parity, score every technique, write the
// pictures. Sees only Renderer&.

#include "core/renderer.h"
#include "lab/causes/causes_wanted.h"
#include "results/metric_choice.h"
#include "results/results.h"
#include "results/technique_run.h"
#include "scenes/scene.h"

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace umbrameter {

class ValidationCache;  // lab/validation_cache.h

/// A loaded scene under the name the user knows it by.
struct SceneJob {
  std::string name;  // unique in the plan
  Scene scene;
};

/// A scene that is loaded when more than its description is needed.
struct SceneSource {
  SceneResult description;  // without results
  LightType light = LightType::rect;
  size_t active_light = 0;
  std::vector<std::filesystem::path> side_files;  // as Scene's
  std::function<std::shared_ptr<const Scene>()> load;
};

/// `job` must outlive it.
SceneSource source_of(const SceneJob& job);

struct ValidationPlan {
  std::string quality;
  /// Samples and target are those that the reference renderer was made with; recorded. The seed is also the runs'.
  PictureQuality picture{.width_px = 960, .height_px = 540, .samples_per_pixel = 1024};
  int timed_frames = 9;          // wanted; fewer when they would exceed the budget, never fewer than 1
  double timing_budget_s = 3.0;  // a technique and scene
  int temporal_frames = 0;       // of each sequence; 0 leaves them out
  std::string motion;            // of standard_motion(), instead of the scene's; empty: its own
  std::vector<TechniqueRun> techniques;
  MetricChoice metrics;
  /// Label of the technique that verdicts compare with; empty: `hard` where it has a result, else a scene's first that has.
  std::string baseline;
  std::optional<double> limit_rmse;
  bool maps = false;  // also an EXR of metrics/maps.h a run
  CausesWanted causes = CausesWanted::none;
  bool skip = true;  // what a scene does not need; off: everything is rendered and scored
};

struct Renderers {
  Renderer& reference;
  Renderer& realtime;
};

/// Why `run` is left out of `scene`, if it is.
std::optional<std::string> skip_reason(const TechniqueRun& run, LightType light,
                                       const std::string& light_name);
std::optional<std::string> skip_reason(const TechniqueRun& run, const Scene& scene);

/// Called after each scene, for a line on the terminal.
using SceneDone = std::function<void(const SceneResult&)>;

/// Runs everything; a run that throws is recorded and the rest goes on (Error{cancelled} passes through, and
/// so does a failure to write). Images and pictures go into `folder`/images/<scene>/. Results carry version
/// and commit.
Results run_validation(std::span<const SceneJob> scenes, const ValidationPlan& plan, Renderers renderers,
                       const std::filesystem::path& folder, Progress& progress,
                       const SceneDone& scene_done = {});

/// The same; what `memory` (may be null) knows is not rendered again, and it learns the rest.
Results run_validation(std::span<const SceneSource> scenes, const ValidationPlan& plan, Renderers renderers,
                       const std::filesystem::path& folder, Progress& progress, const SceneDone& scene_done,
                       ValidationCache* cache);

}  // namespace umbrameter
