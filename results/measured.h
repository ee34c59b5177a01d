// SPDX-License-Identifier: Apache-2.0
#pragma once
// Nothing measured never passes: the one rule by which every verb decides whether a score says anything.

#include "results/results.h"

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

/// Why there is no run with a score in `scene`: the scene's own reason, or its runs'. A scene with a truth has none of its
/// own: what its truth saved is noted there, too.
std::string why_none(const std::vector<Skip>& skipped, const std::string& scene, bool has_truth);

/// Of a validation.
std::vector<MeasuredScene> measured_scenes(const Results& results);

}  // namespace umbrameter
