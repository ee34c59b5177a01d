// SPDX-License-Identifier: Apache-2.0
#pragma once
// Where the shadow rays of a reference frame went, and which rule saved the others.

#include "core/image.h"

namespace umbrameter {

/// Shares are of all pixels and add up to 1.
struct RayBudget {
  double rays_per_pixel = 0.0;          // samples of visibility; probes of blockers not counted
  double uniform_rays_per_pixel = 0.0;  // had every pixel that light can reach as many as the neediest
  double background = 0.0;
  double unlit = 0.0;  // turned away from the light
  double proven_lit = 0.0;
  double proven_dark = 0.0;  // one triangle, or the receiver's own plane, hides the whole light
  double sampled = 0.0;
};

/// From the channels of a frame (reference/reference.h).
RayBudget ray_budget(const Image& reference);

}  // namespace umbrameter
