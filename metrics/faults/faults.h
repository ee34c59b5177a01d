// SPDX-License-Identifier: Apache-2.0
#pragma once
// Gives every wrongly shadowed pixel a cause (METRICS 6.7 to 6.9). The definitions are ours: no accepted ones
// exist for acne, peter-panning or leaks. Not here: whether a pixel is wrong at all (metrics/penumbra/envelope.h).

#include "metrics/penumbra/envelope.h"

#include <array>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace umbrameter {

enum class FaultClass : uint8_t {
  unscored,           // masked out
  explained,          // within what a slight shift, a slight width error or the reference's noise explains
  acne,               // unexplained dark where all around is fully lit
  terminator,         // unexplained dark where shading and geometric normals disagree
  extra_shadow,       // a solid dark shape the truth has not
  penumbra,           // unexplained in or along a penumbra: its softness is wrong
  overlap,            // the same where penumbrae overlap
  penumbra_too_wide,  // the shadow's edge reaches further out and further in than the true one: a filter too wide
  resolution,         // unexplained within a texel and a half of an edge narrower than two texels
  peter_panning,      // unexplained bright where the blocker is in contact
  bleed,              // unexplained, not full, bright where several blockers lie behind each other
  geometric_leak,  // other unexplained bright in shadow: missing caster, culling, cascade edge
  lost_shadow,     // a whole shadow of the truth that the test has not
};
inline constexpr size_t kFaultClasses = 13;

/// The enumerator's own word.
std::string_view name_of(FaultClass fault);

struct FaultSettings {
  /// Blockers closer than this are in contact. Absent: 6 pixels' extent on the receiver, 3 texels or 2 biases,
  /// whichever is most.
  std::optional<double> contact_distance_world;
  double lit_epsilon = 0.01;            // fully lit: 1 - this
  double terminator_deg = 10.0;         // between shading and geometric normal
  double bleed_layers = 1.25;           // blockers on a blocked ray, on average
  double bleed_max_visibility = 0.8;    // mean over the component; a missing caster leaves full light
  double lost_overlap = 0.2;            // share of a shadow that may be found and the shadow still be lost
  size_t min_component_px = 12;         // of a lost or extra shadow
  double extra_shadow_radius_px = 8.0;  // inscribed; thinner shapes are acne
};

struct FaultShare {
  size_t pixels = 0;
  size_t components = 0;        // connected places; 0 for unscored and explained
  double mean_abs_error = 0.0;  // sum |V - R| over its pixels, over all scored pixels
};

struct Faults {
  int width = 0, height = 0;
  std::vector<FaultClass> classes;  // [height][width]
  size_t scored_pixels = 0;
  std::array<FaultShare, kFaultClasses> by_class;  // mean_abs_error adds up to the image's
  std::optional<double> mean_abs_error;            // absent when nothing is scored
  std::optional<double>
      peter_panning_gap_world;  // median over components of the widest place; absent without any

  const FaultShare& of(FaultClass fault) const { return by_class[static_cast<size_t>(fault)]; }
};

/// `envelope` and `profiles` are those of the same pair and mask. Beside visibility needs, in the reference,
/// position, normal, shading_normal, primitive_id, blocker_distance_min and blocker_layers (both 0 where
/// unknown); uses texel.x, texel.y, texel_world and bias_world of the test if it has them. A component of the residual gets
/// the class that four fifths of it speak for; a mixed one is divided. Error{input} on size mismatch, missing
/// channels, NaN, values outside [0,1].
Faults classify_faults(const Image& test, const Image& reference, std::span<const uint8_t> mask,
                       std::span<const PenumbraProfile> profiles, const Envelope& envelope,
                       const FaultSettings& settings = {});

}  // namespace umbrameter
