// SPDX-License-Identifier: Apache-2.0
#pragma once
// How wide a technique's penumbrae are, and where their edges lie, against the truth (METRICS 5a, 6.5). The
// definition is ours: no accepted one exists. docs/metrics.md explains the choices.

#include "core/image.h"

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace umbrameter {

struct PenumbraSettings {
  int seed_spacing_px = 8;    // at most one profile a cell of this size
  double reach = 0.99;        // a reference without both plateaus must span 1 - reach .. reach
  double test_reach = 0.85;   // and the test's this much: a constant bleed is no width error
  double min_width_px = 3.0;  // narrower ones are mostly pixel
  int max_length_px = 512;    // of a walk to either side of the ridge
  double max_test_rms = 0.1;  // from the test's monotone fit; above, it is too noisy or not an edge
  /// Of a true width. Less is hard, whatever the picture's size: width_octaves go no lower than its logarithm.
  double hardest_share = 0.125;
  double least_levels = 0.35;       // that a stretch without plateaus must span in the reference,
  double least_test_levels = 0.15;  // and that both must share
};

/// What became of a profile; the reference is judged before the test.
enum class ProfileOutcome : uint8_t {
  accepted,
  no_ridge,           // penumbra whose visibility does not cross .5 (umbra-less), and too faint to compare
  discontinuity,      // the surface, the image or the mask ends inside the penumbra, and too little is left
  unreached,          // turns round or runs on before full light and full shadow: penumbrae overlap too much
  not_monotone,       // residual of the monotone fit above three standard errors
  too_narrow,         // less than min_width_px
  test_unreached,     // the test has no edge there
  test_not_monotone,  // the test's residual is above max_test_rms
};
inline constexpr size_t kProfileOutcomes = 8;

/// The enumerator's own word.
std::string_view name_of(ProfileOutcome outcome);

/// One walk along the gradient of the reference's visibility on the receiver. Widths are those of a box ramp
/// of equal second moment: a rectangular light with an edge along the blocker gives its penumbra width w, a
/// disk .866 w. Where a penumbra is not whole (no umbra, overlap, a surface that ends) the stretch that there is tells
/// them: the test's positions at the levels that both have, as the reference's own, moved and stretched.
struct PenumbraProfile {
  int x = 0, y = 0;  // pixel on the ridge, visibility about .5 (.25 or .75 where it does not get that far)
  /// Its index in a plane `width` px wide.
  size_t pixel(int width) const {
    return static_cast<size_t>(y) * static_cast<size_t>(width) + static_cast<size_t>(x);
  }
  ProfileOutcome outcome = ProfileOutcome::accepted;
  double reference_width_px =
      0.0;  // along the walk; when not measured from the slope, at most the widest measured
  double reference_width_world = 0.0;
  double reference_width_10_90_world = 0.0;
  double test_width_world = 0.0;  // from here on only when accepted
  double test_width_10_90_world = 0.0;
  double width_octaves = 0.0;        // log2(test / reference), at least log2(hardest_share)
  double width_10_90_octaves = 0.0;  // the same of those widths
  double offset_world = 0.0;         // of the test's middle, positive towards the light: shadow too large
  size_t ramp_px = 0;                // pixels where the reference is between .05 and .95
  size_t ramp_levels = 0;            // distinct visibilities of the test there, told apart to 1/4096
  /// offset_world of profiles that are too narrow, too: an edge has a place without a width.
  std::optional<double> edge_offset_world;
  bool has_ridge = true;    // the reference's visibility crosses .5
  bool overlaps = false;    // it turns round before full light or full shadow
  bool is_partial = false;  // accepted by a stretch without both plateaus
};

struct Spread {
  double median = 0.0, p5 = 0.0, p95 = 0.0;
  double rmse = 0.0;     // root mean square, from 0
  double rmse_se = 0.0;  // its standard error if the values were independent; 0 for a single one
  size_t count = 0;
};

/// Spreads are of profiles with both plateaus, of stretches where there is none. Absent: no profile was accepted.
struct PenumbraError {
  std::vector<PenumbraProfile> profiles;  // every seed, in reading order of the cells
  std::array<size_t, kProfileOutcomes> outcomes{};
  size_t partial = 0;                   // of those accepted
  std::optional<Spread> width_octaves;  // log2(test / reference)
  std::optional<Spread> width_10_90_octaves;
  std::optional<Spread> offset_world;
};

/// Walks from pixels on the ridge (visibility .5) of `reference` over its receiver and compares the monotone
/// fits of both visibilities; where a shadow has no umbra, or light between shadows is not full, from visibility .75 or .25. Needs visibility in both, visibility_se, position, normal and primitive_id in
/// the reference. Error{input} on size mismatch, missing channels, NaN, values outside [0,1].
PenumbraError measure_penumbra(const Image& test, const Image& reference, std::span<const uint8_t> mask,
                               const PenumbraSettings& settings = {});

/// 5 %, 50 % and 95 % quantiles and root mean square; absent for no values.
std::optional<Spread> spread_of(std::vector<double> values);

}  // namespace umbrameter
