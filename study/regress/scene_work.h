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

/// A truth that can get more samples. It is rendered when its pixels are asked for.
class Truth {
 public:
  explicit Truth(const SceneWork& work) : work_(work) {}

  /// At least so many samples per pixel; those that are there are kept.
  void grow_to(int samples);
  int samples() const { return samples_; }
  const Image& image();
  TruthNumbers numbers();
  /// Of what it is, in the store.
  std::string key() const;

 private:
  SceneWork work_;
  Image image_;
  std::string device_;
  int samples_ = 0;
  std::vector<int> parts_;  // samples of each
  size_t rendered_ = 0;     // parts
};

/// One run of a scene with its pictures of different seeds. They are drawn when nothing is known of them.
struct RunWork {
  const TechniqueRun& run;
  size_t seeds = 1;  // pictures that its numbers are of
  std::vector<Image> pictures;
  std::optional<Failure> failure;
  BaselineRun described;  // all but its numbers
  std::vector<uint8_t> mask;
};

/// Every run of the plan that supports the scene's light, with a picture where the plan times them, in turn; the others join
/// `skipped`.
std::vector<RunWork> choose_runs(const SceneWork& work, std::vector<Skip>& skipped);

/// `seed_sd` is what the baseline says of one picture; the mean's is less. Absent: it is measured from the run's pictures.
Measured measure(const SceneWork& work, RunWork& run, Truth& truth, std::optional<double> seed_sd);

}  // namespace umbrameter
