// SPDX-License-Identifier: Apache-2.0
#pragma once
// A scene with its truth and pictures of it, for trials of the gate. Not here: which faults there are.

#include "lab/answers.h"
#include "lab/keys.h"
#include "study/gate.h"
#include "study/metric_probe.h"
#include "study/resolved.h"

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace umbrameter {

struct SelftestRenderers {
  Renderer& reference;
  Renderer& reference_other_threads;  // the same with another number of threads
  Renderer& realtime;
};

/// A size and samples that everything is tried with.
struct SelftestRound {
  int width_px = 320;
  int height_px = 180;
  uint64_t seed = 1;
  auto operator<=>(const SelftestRound&) const = default;
};
/// "320 x 180 px, seed 1".
std::string text_of(const SelftestRound& round);

struct TechniqueChoice {
  std::string technique;  // id or folder
  ParameterValues parameters;
};

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

/// `parameters` over those of `choice`.
TechniqueChoice with(TechniqueChoice choice, const ParameterValues& parameters);

/// What the gate saw of a picture.
struct Examined {
  GateRun run;
  std::vector<uint8_t> mask;              // scored pixels; empty when void
  std::vector<FaultClass> fault_classes;  // [height][width]; empty when void
};

Examined examine(const Image& picture, const Image& truth, const glm::dvec3& eye_world,
                 const ErrorMetric& metric = error_metric);

class Stage {
 public:
  Stage(SceneJob job, const SelftestSettings& settings, const SelftestRound& round,
        SelftestRenderers renderers, Progress& progress);

  const std::string& name() const { return job_.name; }
  const Scene& scene() const { return job_.scene; }
  const SelftestSettings& settings() const { return settings_; }
  const SelftestRound& round() const { return round_; }
  /// Of its truths and pictures unless they name another: the round's, or the last `repeat`'s.
  uint64_t seed() const { return seed_; }
  const glm::dvec3& eye_world() const { return job_.scene.camera.eye_world; }

  /// Truths and pictures that name no seed are of this one from here on.
  void repeat(uint64_t seed) { seed_ = seed; }

  const Image& truth();
  /// The truth again with other samples: a picture without a fault.
  const Image& exact();
  const Examined& examined_exact();
  /// The truth of another scene under this one's name: visibility, its halves and its blockers alone. Elsewhere,
  /// where a changed scene shows another surface, this one's truth stays.
  Image truth_of_shadows(const Scene& changed);
  Image truth_of(const Scene& changed, uint64_t seed);
  Image truth_with_other_threads();

  const Image& picture(const TechniqueChoice& choice);
  const Examined& examined(const TechniqueChoice& choice);
  Image picture(const TechniqueChoice& choice, uint64_t seed);
  /// By the map that `choice` draws.
  Unresolved unresolved(const TechniqueChoice& choice);
  /// The shadows that `choice` draws of a changed scene, on the surfaces of this one.
  Image picture_of_shadows(const TechniqueChoice& choice, const Scene& changed);
  /// The same on the surfaces of another picture of this scene; `blocker_truth` as RenderRequest's.
  Image shadows_of(const TechniqueChoice& choice, const Scene& changed, const Image& surfaces,
                   const Image* blocker_truth = nullptr);

 private:
  std::string key_of(const std::string& what) const;
  Image render(Renderer& renderer, const Scene& scene, uint64_t seed, const TechniqueChoice& choice,
               const Image* blocker_truth = nullptr);

  SceneJob job_;
  SelftestSettings settings_;
  SelftestRound round_;
  SelftestRenderers renderers_;
  Progress& progress_;
  uint64_t seed_;
  std::map<std::string, Image> pictures_;
  std::map<std::string, Examined> examined_;
};

}  // namespace umbrameter
