// SPDX-License-Identifier: Apache-2.0
// Percentage-closer filtering (Reeves, Salesin and Cook 1987) with a box of real-valued width: texels at the
// border count by the part of them that the box covers.
#include "box_filter.glsl"
#include "shadow_map.glsl"

/// Mean of the comparisons over a box around the receiver.
float box_lit(sampler2D map, LightViewData view, Receiver receiver, float width_texels) {
  vec2 center = texel_position(view, receiver.lateral);
  vec2 low = center - 0.5 * width_texels;
  vec2 high = center + 0.5 * width_texels;
  ivec2 first = ivec2(floor(low));
  ivec2 last = ivec2(last_texel(low.x, high.x), last_texel(low.y, high.y));
  vec2 lit_and_total = vec2(0.0);
  for (int y = first.y; y <= last.y; ++y) {
    for (int x = first.x; x <= last.x; ++x) {
      float weight = box_weight(x, low.x, high.x) * box_weight(y, low.y, high.y);
      float lit = is_blocked(map, view, receiver, ivec2(x, y)) ? 0.0 : 1.0;
      lit_and_total += weight * vec2(lit, 1.0);
    }
  }
  return lit_and_total.x / lit_and_total.y;
}
