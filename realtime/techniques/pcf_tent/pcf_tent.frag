// SPDX-License-Identifier: Apache-2.0
// Percentage-closer filtering with a tent, two weighted texels a side in each fetch.
#include "gather.glsl"
#include "pixel.glsl"

const int kMiddle = SIZE + 1;  // const: of a grid of 3, 5 or 7

/// Weight of row or column `index` of the grid; 0 beside it.
float grid_weight(int index) {
  int from_middle = abs(index - kMiddle);
  if (from_middle > kMiddle) return 0.0;
  if (WEIGHTS == WEIGHTS_TENT) return float(kMiddle + 1 - from_middle);
  // const: The Witness, 1 2 1, 1 3 4 3 1 and 1 5 12 16 12 5 1, from the middle outwards
  const vec4 published[3] = vec4[](vec4(2, 1, 0, 0), vec4(4, 3, 1, 0), vec4(16, 12, 5, 1));
  return published[SIZE][from_middle];
}

/// Weights of texels `index` and `index + 1`, counted from the lowest: the grid is blended with itself a texel on, by
/// the receiver's place between texel centres.
vec2 pair_weights(int index, float share) {
  return vec2(mix(grid_weight(index), grid_weight(index - 1), share),
              mix(grid_weight(index + 1), grid_weight(index), share));
}

float tent_mean(Receiver receiver) {
  const int gathers = kMiddle + 1;  // a side
  vec2 p_texels = texel_position(view_light, receiver.lateral) - 0.5;
  vec2 share = fract(p_texels);
  ivec2 first = ivec2(floor(p_texels)) - kMiddle;
  vec2 lit_and_total = vec2(0.0);
  for (int i = 0; i < gathers * gathers; ++i) {
    ivec2 index = 2 * ivec2(i % gathers, i / gathers);
    vec4 weights = gather_weights(pair_weights(index.x, share.x), pair_weights(index.y, share.y));
    vec4 lit = gather_lit(shadow_map, view_light, receiver, first + index);
    lit_and_total += lit_and_total_of(weights, lit);
  }
  return lit_and_total.x / lit_and_total.y;
}

float visibility_of(Receiver receiver) {
  float known;
  return is_known(view_light, receiver, known) ? known : tent_mean(receiver);
}

void main() {
  Receiver receiver;
  out_visibility = fetch_receiver(receiver) ? visibility_of(receiver) : 1.0;
}
