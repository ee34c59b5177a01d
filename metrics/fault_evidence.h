#pragma once
// What speaks for which cause, a component of the envelope residual at a time. Not here: the verdict
// (metrics/faults.h).

#include "metrics/components.h"
#include "metrics/faults.h"
#include "metrics/surface.h"

#include <cstdint>
#include <span>
#include <vector>

namespace umbrameter {

/// The pair and its AOVs; views into images that must outlive it.
struct FaultInput {
  std::span<const float> v, r;
  std::span<const uint8_t> mask;
  std::span<const PenumbraProfile> profiles;
  const Envelope& envelope;
  const FaultSettings& settings;
  SurfaceView surface;
  std::array<std::span<const float>, 3> shading_normal;
  std::span<const float> blocker_distance, blocker_layers;
};

/// Sums over a component. `mass` weighs by residual; the others are the mass that meets a condition.
struct Evidence {
  size_t pixels = 0;
  double mass = 0.0;
  double lit = 0.0;                    // fully lit all around
  double terminator = 0.0;             // normals disagree
  double contact = 0.0;                // nearest blocker in contact
  double layered = 0.0;                // at least bleed_layers blockers
  double penumbra = 0.0;               // within one width of a penumbra at least 3 px wide
  double test = 0.0, reference = 0.0;  // mass times visibility
  double width_px = 0.0;               // mass times the nearest penumbra's width

  bool mostly(double part, double share = 0.5) const { return part > share * mass; }
};

/// One a component of `residual` > 0.
std::vector<Evidence> gather_evidence(const FaultInput& input, std::span<const float> residual,
                                      const Components& components,
                                      std::span<const int32_t> nearest_penumbra);

/// Nearest scored pixel with .2 < R < .8, -1 without any.
std::vector<int32_t> nearest_penumbra_pixels(const FaultInput& input);

}  // namespace umbrameter
