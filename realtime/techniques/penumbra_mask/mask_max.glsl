// SPDX-License-Identifier: Apache-2.0
// One axis of the 7 x 7 maximum.
#include "mask_value.glsl"

/// The widest penumbra among seven texels.
vec2 widest_of(sampler2D map, ivec2 texel, ivec2 axis) {
  ivec2 last = textureSize(map, 0) - 1;
  vec2 widest = vec2(0.0);
  for (int i = -3; i <= 3; ++i) {  // const: 7 texels
    widest = max(widest, texelFetch(map, clamp(texel + i * axis, ivec2(0), last), 0).rg);
  }
  return widest;
}
