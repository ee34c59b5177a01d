// SPDX-License-Identifier: Apache-2.0
#pragma once
// Why an image's shadows are wrong: penumbra widths, contact hardening and a class for every wrong pixel
// (docs/metrics.md). Not here: how wrong they are (lab/score.h).

#include "core/image.h"
#include "metrics/causes/causes.h"
#include "metrics/faults/faults.h"
#include "metrics/faults/moire.h"
#include "metrics/penumbra/contact_hardening.h"
#include "metrics/penumbra/penumbra.h"

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace umbrameter {

/// PenumbraError without its profiles. Spreads are absent when no profile was accepted.
struct PenumbraNumbers {
  std::array<size_t, kProfileOutcomes> outcomes{};
  size_t partial = 0;  // of those accepted: measured on a stretch without both plateaus
  std::optional<Spread> width_octaves;
  std::optional<Spread> width_10_90_octaves;
  std::optional<Spread> offset_world;
  std::optional<Spread> offset_widths;  // the same, in widths of the true penumbra
  std::optional<Spread> offset_texels;  // the same, in widths of a texel facing the light; of known texels

  size_t accepted() const { return outcomes[0]; }
  size_t rejected() const;
};

/// Faults without its per-pixel classes.
struct FaultNumbers {
  size_t scored_pixels = 0;
  std::array<FaultShare, kFaultClasses> by_class;
  std::optional<double> mean_abs_error;
  std::optional<double> peter_panning_gap_world;

  const FaultShare& of(FaultClass fault) const { return by_class[static_cast<size_t>(fault)]; }
};

struct Diagnosis {
  PenumbraNumbers penumbra;
  ContactHardening contact_hardening;
  FaultNumbers faults;
  Moire moire;
  ErrorCauses causes;
};

struct DiagnosedImage {
  Diagnosis numbers;
  std::vector<FaultClass> classes;  // [height][width]
  std::vector<PenumbraProfile> profiles;
};

/// Of the mean absolute error: a class with a smaller part is not named.
inline constexpr double kNamedShare = 0.1;

/// Classes with that part or more, the largest first; the worst where none has; nothing without any.
std::vector<FaultClass> named_faults(const FaultNumbers& faults);

/// The class with the largest part of the mean absolute error, a wrong softness among them; not what is explained.
/// Absent without any.
std::optional<FaultClass> worst_fault(const FaultNumbers& faults);

/// Needs visibility in `test` (and uses texel.x, texel.y, texel_world if there), and in `reference` also visibility_se, position, normal, shading_normal,
/// primitive_id, blocker_distance_min and blocker_layers. Error{input} as for the metrics.
DiagnosedImage diagnose(const Image& test, const Image& reference, std::span<const uint8_t> mask);

}  // namespace umbrameter
