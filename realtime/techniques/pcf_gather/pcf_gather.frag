// SPDX-License-Identifier: Apache-2.0
// Percentage-closer filtering with a box of a whole number of texels, read four texels a fetch.
#include "box_filter.glsl"
#include "gather.glsl"
#include "pixel.glsl"

/// Weights of texels `index` and `index + 1`, counted from the lowest the box touches; it starts at `low` in [0,1).
vec2 pair_weights(int index, float low) {
  float high = low + float(FILTER_WIDTH_TEXELS);
  return vec2(box_weight(index, low, high), box_weight(index + 1, low, high));
}

float box_mean(Receiver receiver) {
  int gathers = FILTER_WIDTH_TEXELS / 2 + 1;  // a side: the box touches a texel more than its width
  vec2 p_texels = texel_position(view_light, receiver.lateral) - 0.5 * float(FILTER_WIDTH_TEXELS);
  vec2 first = floor(p_texels);
  vec2 low = p_texels - first;
  vec2 lit_and_total = vec2(0.0);
  for (int i = 0; i < gathers * gathers; ++i) {
    ivec2 index = 2 * ivec2(i % gathers, i / gathers);
    vec4 weights = gather_weights(pair_weights(index.x, low.x), pair_weights(index.y, low.y));
    vec4 lit = gather_lit(shadow_map, view_light, receiver, ivec2(first) + index);
    lit_and_total += lit_and_total_of(weights, lit);
  }
  return lit_and_total.x / lit_and_total.y;
}

float visibility_of(Receiver receiver) {
  float known;
  return is_known(view_light, receiver, known) ? known : box_mean(receiver);
}

void main() {
  Receiver receiver;
  out_visibility = fetch_receiver(receiver) ? visibility_of(receiver) : 1.0;
}
