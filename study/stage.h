// SPDX-License-Identifier: Apache-2.0
#pragma once
// A scene with its truth and pictures of it, for trials of the gate. Not here: which faults there are.

#include "lab/answers.h"
#include "lab/keys.h"
#include "lab/scene_pictures.h"
#include "results/selftest/outcome.h"

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace umbrameter {

/// What is asked of every scene.
struct SelftestParts {
  bool benign = true;      // changes that are no faults, and masks
  bool faults = true;      // those of the scene
  bool causes = false;     // what mends faults, in the first round
  bool hardening = false;  // whether the scene tells contact hardening, in the first round
};

struct SelftestSettings {
  std::vector<SelftestRound> rounds = {SelftestRound{}};
  SelftestParts parts;
  std::string only;          // trials whose name contains it; empty: all
  size_t fewest_benign = 0;  // further rounds of other sizes and seeds until there are as many
  std::filesystem::path techniques_folder, shaders_folder;  // to make mutants from
  std::filesystem::path scratch_folder;                     // where mutants go
  std::filesystem::path pictures_folder;                    // of what was judged; empty: none are kept
  /// What a choice is, with all its parameters and those that may be replaced; needed for causes.
  std::function<TechniqueRun(const TechniqueChoice&)> describe_run;
  Answers* answers = nullptr;   // where outcomes are kept; null: nowhere
  Makers makers = {};           // of what is kept
  int samples_per_pixel = 0;    // that the reference was made with
  std::string techniques_hash;  // of the folder
};

/// Of the pictures of a round.
PictureQuality quality_of(const SelftestSettings& settings, const SelftestRound& round);

/// Trials are made on it.
class Stage : public ScenePictures {
 public:
  Stage(SceneJob job, const SelftestSettings& settings, const SelftestRound& round,
        PictureRenderers renderers, Progress& progress);

  const SelftestSettings& settings() const { return settings_; }
  const SelftestRound& round() const { return round_; }

 private:
  SelftestSettings settings_;
  SelftestRound round_;
};

}  // namespace umbrameter
