// SPDX-License-Identifier: Apache-2.0
#pragma once
// The steps of one scene's validation, each guarded on its own. Not here: their order (lab/validation.cpp).

#include "lab/score.h"
#include "lab/validation.h"

#include <functional>

namespace umbrameter {

/// What every step needs.
struct SceneContext {
  const std::string& name;  // unique in the results
  const Scene& scene;
  const ValidationPlan& plan;
  Renderers renderers;
  std::filesystem::path folder;  // of all results
  Progress& progress;

  /// Where `file` of this scene goes, relative to `folder`.
  std::string relative(const std::string& file) const;
};

/// images/<scene>/<file>: where an image goes, relative to the results folder.
std::string image_path(const std::string& scene, const std::string& file);

/// A run with its picture, until it is scored.
struct TechniqueFrame {
  TechniqueRun technique;
  TechniqueResult result;
  Frame frame;
  std::vector<uint8_t> mask;  // scored pixels
  std::string key;            // in the store; empty without one
  double scoring_s = 0.0;
  bool lacks_pictures = false;  // scored by a sweep, which makes none for people
  bool has_verdict = false;     // known, though there may be none
};

/// Every run of the plan that supports the light, undone; the others join `skipped`.
std::vector<TechniqueFrame> choose_runs(const ValidationPlan& plan, const SceneResult& scene, LightType light,
                                        std::vector<Skip>& skipped);

/// Renders all runs that are not reused, stores their images, and times them in turn.
void render_techniques(const SceneContext& context, std::span<TechniqueFrame> runs);

/// The truth: read when scene.reference is known, else rendered and stored. Sets scene.reference, or scene.failure.
Image require_reference(const SceneContext& context, SceneResult& scene);

/// Sets scene.parity, or scene.failure, and stores the parity picture.
void compare_renderers(const SceneContext& context, const Image& surfaces, const Image& reference,
                       SceneResult& scene);

/// Called with a run when nothing more becomes known of it, so that it can be kept before the next one is begun.
using RunDone = std::function<void(TechniqueFrame&)>;

/// Sets the errors of the runs that are not reused, or their failures, and stores their pictures.
void score_techniques(const SceneContext& context, const Image& reference, std::span<TechniqueFrame> runs,
                      const RunDone& run_done);

// The same where frames and scores are there already: what they become in the results, with their pictures.
void take_truth(const SceneContext& context, const Image& image, ReferenceResult result, SceneResult& scene);
void take_parity(const SceneContext& context, const Parity& parity, SceneResult& scene);
void take_score(const SceneContext& context, const Image& reference, Score score, TechniqueFrame& run);

/// The pictures of runs that lack them, from what a sweep kept.
void draw_swept(const SceneContext& context, const Image& reference, std::span<TechniqueFrame> runs);

/// Reads the picture of a run that was scored by another process.
void require_picture(const SceneContext& context, const Image& reference, TechniqueFrame& run);

/// The run that the others' verdicts compare with; null when verdicts are not wanted and when it has no score here.
TechniqueFrame* baseline_of(const ValidationPlan& plan, std::span<TechniqueFrame> runs);

/// Sets the verdicts of all scored runs that have none yet.
void compare_with_baseline(const SceneContext& context, const Image& reference,
                           std::span<TechniqueFrame> runs);

}  // namespace umbrameter
