// SPDX-License-Identifier: Apache-2.0
#pragma once
// What speaks for which cause: signs of single pixels of the envelope residual, and their sums over components.
// Not here: the verdict (metrics/faults/faults.h).

#include "metrics/faults/faults.h"
#include "metrics/image/components.h"
#include "metrics/image/surface.h"
#include "metrics/image/texel_footprint.h"

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
  std::span<const float> irradiance;  // without shadows; empty where unknown
  float largest_irradiance = 0.0f;
  TexelView texels;

  double error(size_t i) const { return static_cast<double>(v[i]) - r[i]; }
};

/// What a pixel of the residual says by itself.
enum class Sign : uint8_t {
  plain,       // all around the truth is fully lit (too dark) or fully shadowed (too bright)
  terminator,  // normals disagree, or the receiver hides the light from itself
  contact,     // shadowed by a blocker in contact, or no further from the light than a large bias reaches
  layered,     // several blockers on its rays, and plain
  edge,        // within a texel and a half of a true edge that is narrower than two texels
  near,        // within one width of a penumbra at least 3 px wide
  overlap,     // the nearest penumbra overlaps another
  separate,    // it has a ridge and overlaps none
  touching,    // contact that the picture or a bias tells, not the width of texels alone
  blurred,     // the outskirt of a true edge that is drawn wider on both sides: metrics/faults/blurred_edge.h
  wider,       // the nearest penumbra is drawn wider than the envelope excuses
  alone,       // near, and no penumbra that reaches further explains it: metrics/image/standing_alone.h
};
inline constexpr size_t kSigns = 12;
using Signs = uint16_t;  // bit 1 << Sign

/// What a pixel would be blamed for on its own; pixels of one kind make up a piece of a mixed component.
enum class Kind : uint8_t { partial, plain, alone, layered, contact, blurred, edge, terminator };
inline constexpr size_t kKinds = 8;
Kind kind_of(Signs signs);

/// Sums over a component. `mass` weighs by residual; the others are the mass that meets a condition.
struct Evidence {
  size_t pixels = 0;
  double mass = 0.0;
  std::array<double, kSigns> by_sign{};
  std::array<double, kKinds> by_kind{};
  double test = 0.0, reference = 0.0;  // mass times visibility
  double width_px = 0.0;               // mass times the nearest penumbra's width

  double of(Sign sign) const { return by_sign[static_cast<size_t>(sign)]; }
  bool mostly(Sign sign, double share = 0.5) const { return of(sign) > share * mass; }
  bool mostly(Kind kind) const { return by_kind[static_cast<size_t>(kind)] > 0.5 * mass; }
  bool is_mixed() const;  // no kind has four fifths
};

/// What signs look around for.
struct Surroundings {
  std::vector<int32_t>
      nearest_edge;  // scored pixel with .2 < R < .8 or beside one on the other side of .5; -1 without any
  std::span<const uint8_t> kept;      // 1 on errors that only moved shade: metrics/faults/fault_shapes.h
  std::vector<int32_t> nearest_thin;  // pixel of a shadow thinner than a texel; empty without any
  std::vector<float>
      blurred_truth;  // metrics/faults/blurred_edge.h; empty when the picture is not blurred as a whole
};

/// [height][width] signs of the pixels where `residual` > 0; it is envelope.dark if `is_dark`, else
/// envelope.bright.
std::vector<Signs> read_signs(const FaultInput& input, std::span<const float> residual, bool is_dark,
                              const Surroundings& around);

/// One a component of `residual` > 0.
std::vector<Evidence> gather_evidence(const FaultInput& input, std::span<const float> residual,
                                      std::span<const Signs> signs, const Components& components);

/// Whether the nearest blocker of a shadowed pixel touches it, as far as map and picture can tell.
bool in_contact(const FaultInput& input, size_t i);

/// Whether normals disagree, or a smooth mesh's facets shadow each other where the light grazes them.
bool on_own_facets(const FaultInput& input, size_t i);

/// `thin`: 1 on shadows thinner than a texel, empty without any. `kept` must outlive what is returned.
Surroundings look_around(const FaultInput& input, std::span<const uint8_t> thin,
                         std::span<const uint8_t> kept);

}  // namespace umbrameter
