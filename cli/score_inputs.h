// SPDX-License-Identifier: Apache-2.0
#pragma once
// What `score` compares: pictures of any engine, made into images as ours, and a reference that is read or rendered.

#include "cli/quality.h"
#include "cli/verbs.h"
#include "core/image.h"
#include "study/validation.h"

#include <optional>
#include <string>
#include <vector>

namespace umbrameter {

struct ScoreInputOptions {
  std::string test;
  std::string reference;
  std::string shadowed, unshadowed;
  std::string transfer;
  std::vector<std::string> surfaces;  // images with surface channels
  std::string depth = "axis";
  std::string scene;
  QualityOptions quality;
};

void add_score_input_options(CLI::App& verb, ScoreInputOptions& options);

struct ScoreInputs {
  std::string test_name, reference_name;
  Image test, reference;  // ready for score_image
  glm::dvec3 eye_world{0.0};
  std::optional<SceneJob> scene;    // with --scene
  std::vector<std::string> notes;   // what cannot be known, what was left out, how numbers were rounded
  double mean_square_rounding = 0;  // of visibility
};

/// Error{input} for combinations that say nothing, and other sizes.
ScoreInputs load_score_inputs(const ScoreInputOptions& options, const GlobalOptions& global);

}  // namespace umbrameter
