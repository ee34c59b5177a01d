// SPDX-License-Identifier: Apache-2.0
// First half of the box filter, over the warped moments of each texel; beyond the map is nothing: far.
#include "box_filter.glsl"
#include "exponential_warp.glsl"

vec4 moments_at(ivec2 texel) {
  if (texel.x < 0 || texel.x >= textureSize(surface, 0).x) return warped_moments(1.0, 0.0);
  vec2 z_and_variance = texelFetch(surface, texel, 0).rg;
  return warped_moments(z_and_variance.x, z_and_variance.y);
}

void main() {
  ivec2 texel = ivec2(gl_FragCoord.xy);
  float low = 0.5 - 0.5 * filter_width_texels;
  float high = 0.5 + 0.5 * filter_width_texels;
  vec4 sum = vec4(0.0);
  float total = 0.0;
  for (int i = int(floor(low)); i <= last_texel(low, high); ++i) {
    float weight = box_weight(i, low, high);
    sum += weight * moments_at(texel + ivec2(i, 0));
    total += weight;
  }
  out_moments_x = sum / total;
}
