// SPDX-License-Identifier: Apache-2.0
// Second half of the blur.
#include "mask_blur.glsl"

void main() { out_mask = blurred(mask_x, mask_x_size.zw, vec2(0.0, 1.0)); }
