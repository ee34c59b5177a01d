// SPDX-License-Identifier: Apache-2.0
// The mask: r = penumbra times weight, g = weight. A pixel without blockers has weight 0, or the penumbra that
// mask_default says.
#include "penumbra_code.glsl"

/// As the mask's format keeps it.
vec2 stored(vec2 value) {
  if (MASK_PRECISION == MASK_PRECISION_HALF) return unpackHalf2x16(packHalf2x16(value));
  if (MASK_PRECISION == MASK_PRECISION_BYTE) return unpackUnorm4x8(packUnorm4x8(value.xyxy)).xy;
  return value;
}

vec2 default_value() {
  if (MASK_DEFAULT == MASK_DEFAULT_ZERO) return vec2(0.0, 1.0);
  return MASK_DEFAULT == MASK_DEFAULT_ONE ? vec2(1.0) : vec2(0.0);
}

/// The pixel in the middle of a mask texel (GL's rows).
ivec2 pixel_of_texel(ivec2 texel) {
  return min(texel * MASK_DIVISOR + MASK_DIVISOR / 2, frame.screen_and_seed.xy - 1);
}

/// Where in the mask, in texels, a pixel reads: at the middle of a texel for that texel's pixel.
vec2 texel_of_pixel(vec2 frag_coord) {
  return (frag_coord - 0.5 - float(MASK_DIVISOR / 2)) / float(MASK_DIVISOR) + 0.5;
}
