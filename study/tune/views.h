// SPDX-License-Identifier: Apache-2.0
#pragma once
// Where a tuner looks from: cameras beside a scene's own that see enough of what that sees.

#include "lab/studio.h"

#include <array>
#include <span>
#include <vector>

namespace umbrameter {

/// How far the cameras of a scene go to the left and to the right, in degrees; 0 where none sees enough.
struct Arc {
  double left_deg = 0.0, right_deg = 0.0;
  std::vector<View> ends;  // as they were made to find this, until they are taken
};

/// 26 degrees to either side, or a half or a quarter of that where the outermost camera does not see 30 % of the scene, of the
/// light and of the shadow that the scene's own sees. `own` is that one's view.
Arc find_arc(Studio& studio, const View& own);

/// Cameras between 0 (the scene's own) and 1 (the arc's end) of either side of an arc; the one at 0 is made apart. Those
/// searched with, those that say whether what was found holds elsewhere, and those that are scored and never asked: no two
/// of them share a camera, and each set is spread over the arc.
inline constexpr std::array kSearchedShares = {0.5, 1.0};
inline constexpr std::array kCheckedShares = {0.25, 0.75};
inline constexpr std::array kHeldOutShares = {0.125, 0.375, 0.625, 0.875};

/// Views from there, as `own` is made; takes the arc's ends where they are asked for. A camera is left out where the renderers disagree, and where it does not see enough.
std::vector<View> make_turned_views(Studio& studio, const View& own, Arc& arc,
                                    std::span<const double> shares);

}  // namespace umbrameter
