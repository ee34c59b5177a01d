// SPDX-License-Identifier: Apache-2.0
#pragma once
// What `score` compares: pictures of any engine and their baseline, read by one reader, and a reference that is read or
// rendered.

#include "cli/quality.h"
#include "cli/verbs.h"
#include "core/image.h"
#include "lab/pictures/picture_score.h"
#include "lab/validation.h"

#include <optional>
#include <string>
#include <vector>

namespace umbrameter {

struct ScoreInputOptions {
  std::vector<std::string> pictures;
  std::string reference;
  std::string shadowed, unshadowed;
  std::string baseline;
  std::string transfer;
  PictureChoice choice;
  std::vector<std::string> surfaces;
  std::string depth = "axis";
  std::string axes;
  double unit = 1.0;
  std::string scene;
  bool no_reuse = false;  // render the truth of `scene` though the store in --out knows it
  QualityOptions quality;
};

void add_score_input_options(CLI::App& verb, ScoreInputOptions& options);

struct ScoreInputs {
  std::string reference_name;
  Image reference;
  glm::dvec3 eye_world{0.0};
  std::optional<SceneJob> scene;  // with --scene
  std::vector<EnginePicture> pictures;
  std::optional<EnginePicture> baseline;
};

/// Error{input} for combinations that say nothing, and whatever lab/pictures/picture_score.h refuses.
ScoreInputs load_score_inputs(const ScoreInputOptions& options, const GlobalOptions& global);

}  // namespace umbrameter
