// SPDX-License-Identifier: Apache-2.0
// First half of the maximum.
#include "mask_max.glsl"

void main() { out_mask_x = widest_of(mask, ivec2(gl_FragCoord.xy), ivec2(1, 0)); }
