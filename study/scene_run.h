#pragma once
// The steps of one scene's validation, each guarded on its own. Not here: their order (study/validation.cpp).

#include "study/validation.h"

namespace umbrameter {

/// What every step needs.
struct SceneContext {
  const SceneJob& job;
  const ValidationPlan& plan;
  Renderers renderers;
  std::filesystem::path folder;  // of all results
  Progress& progress;

  /// Where `file` of this scene goes, relative to `folder`.
  std::string relative(const std::string& file) const;
};

/// A run with its picture, until it is scored.
struct TechniqueFrame {
  TechniqueResult result;
  Frame frame;
  std::vector<uint8_t> mask;  // scored pixels
};

/// The plan's size and seed, no technique.
RenderRequest request_of(const ValidationPlan& plan);

/// Renders every technique of the plan that supports the scene's light, stores its image, and times them all in
/// turn; the others join `skipped`.
std::vector<TechniqueFrame> render_techniques(const SceneContext& context, std::vector<Skip>& skipped);

/// Sets the standard errors and sample counts over the covered pixels of a truth.
void summarise_errors(const Image& image, ReferenceResult& result);

/// Renders and stores the truth; sets scene.reference, or scene.failure.
Frame render_reference(const SceneContext& context, SceneResult& scene);

/// Sets scene.parity, or scene.failure, and stores the parity picture.
void compare_renderers(const SceneContext& context, const Image& surfaces, const Image& reference,
                       SceneResult& scene);

/// Sets the run's error, or its failure, and stores its pictures.
void score_technique(const SceneContext& context, const Image& reference, TechniqueFrame& run);

/// Sets the verdicts of all scored runs but the plan's baseline, unless that one has no score here.
void compare_with_baseline(const SceneContext& context, const Image& reference,
                           std::span<TechniqueFrame> runs);

}  // namespace umbrameter
