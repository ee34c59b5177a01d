// SPDX-License-Identifier: Apache-2.0
#pragma once
// A run with one thing replaced by the truth or its limit (metrics/causes/substitutions.h). Which parameters that are follows from the
// manifest's groups, units and scales (docs/causes.md), never from a technique's id.

#include "core/parameters.h"
#include "metrics/causes/substitutions.h"
#include "scenes/light.h"

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace umbrameter {

/// What is known of a run that something is replaced in.
struct SubstitutedRun {
  std::span<const Parameter> declared;  // those that act
  ParameterValues parameters;           // complete, lengths in world units
  Light light;
  double diagonal_world = 0.0;  // of the scene's bounds
  uint64_t memory_bytes = 0;    // of the run's textures
};

/// The run with one thing replaced.
struct Replacement {
  ParameterValues parameters;
  std::vector<Light> lights;         // the picture is the mean over these; one without a change of the light
  bool takes_blocker_truth = false;  // RenderRequest::blocker_truth
  bool moves_texels = false;  // texels become of another size, which only a picture tells: keep_lengths
  std::vector<std::string> changes;  // for people: "map_size 512 -> 2048"
};

/// Absent where the run has nothing of the kind, or it is at its limit already. Maps grow by less where their textures
/// would take more than 2 GiB, or lengths in texels could not grow along.
std::optional<Replacement> replace(const Substitution& substitution, const SubstitutedRun& run);

/// Lengths in texels, but for sizes of maps, by `factor`, within their ranges: as long in the world where a texel is that much
/// smaller now. Whether any changed.
bool keep_lengths(const SubstitutedRun& run, double factor, Replacement& replacement);

}  // namespace umbrameter
