// SPDX-License-Identifier: Apache-2.0
// Second half of the box filter.
#include "esm_filter.glsl"

void main() { out_warped = box_mean(warped_x, ivec2(gl_FragCoord.xy), ivec2(0, 1), filter_width_texels); }
