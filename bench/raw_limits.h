// SPDX-License-Identifier: Apache-2.0
#pragma once
// How fast Embree alone could have done a picture: its rays and nothing else.

#include "core/image.h"
#include "scenes/scene.h"

namespace umbrameter {

/// Processor seconds, the best of several runs.
struct RawLimits {
  double primary_s = 0.0;  // one ray a pixel, 4 x 4 pixels a packet
  double shadow_s = 0.0;   // sample_count of all pixels at the rate of a thousand of them
};

/// `frame` as the reference made it of `scene`.
RawLimits raw_limits(const Scene& scene, const Image& frame);

}  // namespace umbrameter
