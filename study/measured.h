// SPDX-License-Identifier: Apache-2.0
#pragma once
// Nothing measured never passes: the one rule by which every verb decides whether a score says anything.

#include "study/bench.h"
#include "study/results.h"

#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace umbrameter {

/// Of the pixels that the truth can score, this share must have been scored.
inline constexpr double kMinScored = 0.95;

/// Why `scored` of `scorable` pixels say nothing; absent when they do.
std::optional<std::string> unmeasured(size_t scored, size_t scorable, double min_scored = kMinScored);

/// What was scored of one scene.
struct MeasuredScene {
  std::string name;
  size_t scorable_pixels = 0;
  std::vector<std::pair<std::string, size_t>> scored_pixels;  // by label
  std::string why_none;                                       // when no run has a score
  bool is_told = false;  // a failure or a parity that does not hold says it already
};

/// Why scenes or runs say nothing, one sentence each: no run was scored, or too few of its pixels. Also without any scene.
std::vector<std::string> unmeasured(std::span<const MeasuredScene> scenes, double min_scored = kMinScored);

/// Of a validation; of a bench, where parity that does not hold is told here.
std::vector<MeasuredScene> measured_scenes(const Results& results);
std::vector<MeasuredScene> measured_scenes(const BenchResults& results);

}  // namespace umbrameter
