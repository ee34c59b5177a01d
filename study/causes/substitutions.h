// SPDX-License-Identifier: Apache-2.0
#pragma once
// The one list of things that a run's causes are looked for in: what is replaced by the truth or its limit, and how. Which
// parameters that are follows from the manifest's groups, units and scales (docs/causes.md), never from a technique's id.

#include "core/parameters.h"
#include "scenes/light.h"

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace umbrameter {

/// What of a run is replaced.
enum class RunPart : uint8_t { bias, map_size, taps, map_fit, filter_size, light_points, blocker_distance };
std::string_view name_of(RunPart part);

struct Substitution {
  std::string_view id;  // "bias_zero"
  RunPart part = RunPart::bias;
  double factor = 1.0;       // on the part's numbers
  std::string_view label;    // "bias 0": what is put instead
  std::string_view meaning;  // "the bias is too large": what it says where it mends a fault
  double draws = 1.0;        // how many of the run's own pictures it costs, about
  bool replaces_much =
      false;  // where the map stands, how many taps there are and how wide they lie, all at once
};

/// In the order they are tried.
std::span<const Substitution> substitutions();

/// Null for an unknown id.
const Substitution* find_substitution(std::string_view id);

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
