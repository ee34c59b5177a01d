// SPDX-License-Identifier: Apache-2.0
#pragma once
// What mends a run's faults: each is measured again with one thing of the run replaced by the truth or its limit
// (docs/causes.md). Not here: which things those are (metrics/causes/substitutions.h).

#include "core/image.h"
#include "metrics/faults/faults.h"

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace umbrameter {

/// A fault of the run, in its own pixels.
struct CausedFault {
  FaultClass fault = FaultClass::acne;
  size_t pixels = 0;
  double mean_abs_error = 0.0;  // sum |V - R| over its pixels, over all scored pixels: FaultShare's
};

/// What one substitution did.
struct SubstitutionOutcome {
  std::string id;                        // of metrics/causes/substitutions.h
  std::vector<std::string> changes;      // "bias_texels 32 -> 0"
  std::optional<std::string> not_tried;  // why it has no numbers
  /// By fault: 1 - sum |V' - R| / sum |V - R| over the fault's pixels. 1: all is mended; below 0: made worse.
  std::vector<double> removed;
  double elsewhere =
      0.0;  // mean |V' - R| less |V - R| outside these faults, over all scored pixels; above 0: worse
};

struct FaultCauses {
  std::vector<CausedFault> faults;  // the largest first
  std::vector<SubstitutionOutcome>
      outcomes;  // in the order of substitutions(); those the run has nothing of are left out
  std::optional<std::string> skipped;  // why nothing was tried
};

/// A substitution that removes this much of a fault mends it.
inline constexpr double kMends = 0.5;

/// The faults of `classes` [height][width] that `faults` are named in, in this order. Error{input} for another size.
std::vector<CausedFault> caused_faults(std::span<const FaultClass> classes, const Image& test,
                                       const Image& reference, std::span<const FaultClass> faults);

/// Fills in the numbers of `outcome`: `substituted` against `test`, both of the picture that `reference` is the truth
/// of. Pixels of class `unscored` do not count.
void measure_substitution(const Image& substituted, const Image& test, const Image& reference,
                          std::span<const FaultClass> classes, std::span<const CausedFault> faults,
                          SubstitutionOutcome& outcome);

/// What removes most of fault `index`, of those within .05 the one that harms least elsewhere. Only where none mends it: what adds
/// more elsewhere than it mends, then what replaces several things (Substitution::replaces_much). Null when nothing was tried.
const SubstitutionOutcome* best_substitution(const FaultCauses& causes, size_t index);

/// The same where it mends the fault; null otherwise.
const SubstitutionOutcome* cause_of(const FaultCauses& causes, size_t index);

}  // namespace umbrameter
