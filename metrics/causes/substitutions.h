// SPDX-License-Identifier: Apache-2.0
#pragma once
// The one list of things that a run's causes are looked for in: what is replaced by the truth or its limit. Not here: how
// (lab/causes/replacement.h).

#include <cstdint>
#include <span>
#include <string_view>

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

}  // namespace umbrameter
