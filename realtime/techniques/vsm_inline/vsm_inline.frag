// SPDX-License-Identifier: Apache-2.0
// Variance shadow maps whose moments are averaged by each pixel that asks, over a grid of bilinear reads.
#include "filtered_plane.glsl"
#include "pixel.glsl"
#include "variance_bound.glsl"

vec2 grid_moments(vec2 p_texels) {
  vec2 sum = vec2(0.0);
  for (int i = 0; i < GRID_TAPS * GRID_TAPS; ++i) {
    vec2 from_middle = vec2(i % GRID_TAPS, i / GRID_TAPS) - 0.5 * float(GRID_TAPS - 1);
    sum += texture(moments, (p_texels + from_middle) * moments_size.zw).rg;
  }
  return sum / float(GRID_TAPS * GRID_TAPS);
}

float visibility_of(Receiver receiver) {
  float known;
  if (is_known(view_light, receiver, known)) return known;
  receiver.bias_world += plane_bias_world(view_light, receiver, float(GRID_TAPS));
  vec2 filtered = grid_moments(texel_position(view_light, receiver.lateral));
  float bound = variance_visibility(view_light, receiver, filtered);
  return CONTRAST != 0 ? smoothstep(0.0, 1.0, bound) : bound;
}

void main() {
  Receiver receiver;
  out_visibility = fetch_receiver(receiver) ? visibility_of(receiver) : 1.0;
}
