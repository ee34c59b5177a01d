// SPDX-License-Identifier: Apache-2.0
#pragma once
// A scene's truth and pictures while a regression looks at them, and what they measure. Not here: verdicts and in which order
// (study/regress/run.cpp).

#include "study/regress/run.h"

#include <optional>
#include <vector>

namespace umbrameter {

/// Seeds further apart than anybody counts.
inline constexpr uint64_t kSeedStep = 1000003;

struct SceneWork {
  const SceneJob& job;
  const RegressPlan& plan;
  const RegressRenderers& renderers;
  Progress& progress;
};

/// A truth that can get more samples.
class Truth {
 public:
  explicit Truth(const SceneWork& work) : work_(work) {}

  /// At least so many samples a pixel; those that are there are kept.
  void grow_to(int samples);
  const Image& image() const { return image_; }
  int samples() const { return samples_; }
  TruthNumbers numbers() const { return truth_numbers(image_, device_, work_.plan.picture.seed); }

 private:
  SceneWork work_;
  Image image_;
  std::string device_;
  int samples_ = 0;
  uint64_t parts_ = 0;
};

/// One run of a scene with its pictures of different seeds.
struct RunWork {
  const TechniqueRun& run;
  std::vector<Image> pictures;
  std::optional<Failure> failure;
  BaselineRun described;  // all but its numbers
  std::vector<uint8_t> mask;
};

/// A picture of every run of the plan that supports the scene's light, timed in turn; the others join `skipped`.
std::vector<RunWork> first_pictures(const SceneWork& work, std::vector<Skip>& skipped);

/// One more, of the next seed; or the run's failure.
void add_picture(const SceneWork& work, RunWork& run);

/// What the gate calls void, or the numbers of all pictures against this truth.
struct Measured {
  std::optional<CaseVerdict> voided;
  std::optional<CaseNumbers> numbers;
};

/// `seed_sd` is what the baseline says of one picture; the mean's is less.
Measured measure(const SceneWork& work, RunWork& run, const Image& truth, double seed_sd);

}  // namespace umbrameter
