// SPDX-License-Identifier: Apache-2.0
#pragma once
// How near to the light the first caster inside a map's bounds is: penumbra searches reach as far as that
// tells. Internal to views/.

#include "realtime/views/lateral_bounds.h"

namespace umbrameter {

/// Smallest distance in [floor, far] of any triangle's part inside the frustum over `bounds`; `far` when
/// none.
double nearest_caster_perspective(const Scene& scene, const glm::dmat4& light_from_world,
                                  const LateralBounds& bounds, double floor, double far);

/// Smallest distance up to `far` of any triangle's part inside the box over `bounds`; `far` when none.
double nearest_caster_orthographic(const Scene& scene, const glm::dmat4& light_from_world,
                                   const LateralBounds& bounds, double far);

}  // namespace umbrameter
