// SPDX-License-Identifier: Apache-2.0
// First half of the box filter.
#include "esm_filter.glsl"

void main() { out_warped_x = box_mean(warped, ivec2(gl_FragCoord.xy), ivec2(1, 0), filter_width_texels); }
