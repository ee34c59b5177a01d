// SPDX-License-Identifier: Apache-2.0
// What a texel of a light view covers in distance, for techniques with the parameter texel_variance.
#include "moments.glsl"

/// Variance inside the texel whose middle is at `distance_world`, normalised `z`.
float fragment_variance(LightViewData view, float distance_world, float z) {
  // const: sigma^2 of a box of one texel, and of a Gaussian of half a texel
  const float kPerSlope2[3] = float[3](0.0, 1.0 / 12.0, 0.25);
  float texel_normalized = normalized_length(view, texel_world(view, distance_world), distance_world);
  return texel_variance_of(vec2(dFdx(z), dFdy(z)), kPerSlope2[TEXEL_VARIANCE], texel_normalized);
}
