// SPDX-License-Identifier: Apache-2.0
// Percentage-closer filtering on a square grid of taps, each a single comparison or a bilinear blend of four.
#include "pixel.glsl"
#include "shadow_map.glsl"

float grid_mean(Receiver receiver) {
  vec2 center = texel_position(view_light, receiver.lateral);
  vec2 lit_and_total = vec2(0.0);
  for (int i = 0; i < GRID_TAPS * GRID_TAPS; ++i) {
    vec2 from_middle = vec2(i % GRID_TAPS, i / GRID_TAPS) - 0.5 * float(GRID_TAPS - 1);
    float weight = from_middle == vec2(0.0) ? center_weight : 1.0;
    vec2 p_texels = center + spacing_texels * from_middle;
    lit_and_total += weight * vec2(lit_at(shadow_map, view_light, receiver, p_texels, BILINEAR != 0), 1.0);
  }
  return lit_and_total.x / lit_and_total.y;
}

float visibility_of(Receiver receiver) {
  float known;
  return is_known(view_light, receiver, known) ? known : grid_mean(receiver);
}

void main() {
  Receiver receiver;
  out_visibility = fetch_receiver(receiver) ? visibility_of(receiver) : 1.0;
}
