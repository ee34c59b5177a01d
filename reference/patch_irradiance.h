// SPDX-License-Identifier: Apache-2.0
#pragma once
// unshadowed_irradiance() of scenes/light.h, many samples at once: it is asked for at every pixel.

#include "reference/light_patch.h"

namespace umbrameter {

/// From the patch's receiver with nothing in between; equal to the double-precision original to about 1e-5. Where all of
/// the light is above the horizon by Gauss' rule (32 points in the disk, 16 in the square), else over the original's grid.
/// 0 for a dark patch.
double unshadowed_irradiance(const LightPatch& patch);

}  // namespace umbrameter
