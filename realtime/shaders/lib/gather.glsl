// SPDX-License-Identifier: Apache-2.0
// Four comparisons a fetch. Gathered texels are compared one by one, each at its own centre, as single reads are.
#include "shadow_map.glsl"

/// Of the 2 x 2 texels from `low` on: 0 where a texel blocks, else 1, in the order in which GL gathers. Outside the
/// map it reads the border, which is empty.
vec4 gather_lit(sampler2D map, LightViewData view, Receiver receiver, ivec2 low) {
  const ivec2 order[4] = ivec2[](ivec2(0, 1), ivec2(1, 1), ivec2(1, 0), ivec2(0, 0));  // const: GL's
  vec4 depth_reversed = textureGather(map, vec2(low + 1) / view.depth_range.w);
  vec4 lit = vec4(1.0);
  float z_blocker;
  for (int i = 0; i < 4; ++i) {  // const: the corners of a square
    if (is_blocker(view, receiver, low + order[i], depth_reversed[i], z_blocker)) lit[i] = 0.0;
  }
  return lit;
}

/// Products of two columns' and two rows' weights, in the same order.
vec4 gather_weights(vec2 columns, vec2 rows) {
  return vec4(columns.xy * rows.y, columns.yx * rows.x);
}

/// Weighted sum of the four, and the sum of their weights. Precise, or a compiler rounds the two differently and a
/// lit plane is not 1.
vec2 lit_and_total_of(vec4 weights, vec4 lit) {
  precise vec2 sum = vec2(0.0);
  for (int i = 0; i < 4; ++i) sum += weights[i] * vec2(lit[i], 1.0);  // const: of a gather
  return sum;
}
