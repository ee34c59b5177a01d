// SPDX-License-Identifier: Apache-2.0
// Second half of the maximum.
#include "mask_max.glsl"

void main() { out_mask = widest_of(mask_x, ivec2(gl_FragCoord.xy), ivec2(0, 1)); }
