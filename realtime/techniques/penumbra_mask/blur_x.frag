// SPDX-License-Identifier: Apache-2.0
// First half of the blur.
#include "mask_blur.glsl"

void main() { out_mask_x = blurred(mask, mask_size.zw, vec2(1.0, 0.0)); }
