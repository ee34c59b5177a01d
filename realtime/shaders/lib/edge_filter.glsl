// SPDX-License-Identifier: Apache-2.0
// Edges of a shadow map: the Laplacian of its distances, which is 0 on planes and about the height of a step beside
// it. For techniques with the parameters of the group edge_filter.
#include "shadow_map.glsl"

const ivec2 kNeighbours[8] = ivec2[8](  // const: the four that share a side, then those that share a corner
    ivec2(1, 0), ivec2(-1, 0), ivec2(0, 1), ivec2(0, -1), ivec2(1, 1), ivec2(-1, 1), ivec2(1, -1), ivec2(-1, -1));

/// Distance in the world or, as published, 0 near and 1 far as conventional depth buffers hold it. Empty texels are at
/// the far plane, and so is what lies beyond the map: there nothing blocks.
float edge_value(sampler2D map, LightViewData view, ivec2 texel, bool is_stored_depth) {
  float depth_reversed = is_in_map(view, texel) ? texelFetch(map, texel, 0).r : 0.0;
  return is_stored_depth ? 1.0 - depth_reversed : distance_of_depth(view, depth_reversed);
}

/// Height of the step at `texel`, above 0 on its far side, below on its near side. A straight step of eight neighbours
/// counts three times and is scaled back, or not, as published.
float step_height(sampler2D map, LightViewData view, ivec2 texel, bool is_stored_depth) {
  int count = LAPLACIAN == LAPLACIAN_FOUR ? 4 : 8;  // const: neighbours
  float value = edge_value(map, view, texel, is_stored_depth);
  float height = 0.0;
  for (int i = 0; i < count; ++i) height += value - edge_value(map, view, texel + kNeighbours[i], is_stored_depth);
  return LAPLACIAN == LAPLACIAN_EIGHT ? height / 3.0 : height;  // const: neighbours across a straight step
}

/// The same, but never more than the largest difference: corners and lines of one texel count more than once.
float limited_step_height(sampler2D map, LightViewData view, ivec2 texel) {
  float value = edge_value(map, view, texel, false);
  float largest = 0.0;
  for (int i = 0; i < 8; ++i) {  // const: neighbours
    largest = max(largest, abs(value - edge_value(map, view, texel + kNeighbours[i], false)));
  }
  return clamp(step_height(map, view, texel, false), -largest, largest);
}

/// What is compared with a threshold: both sides of a step, or its far side alone.
float edge_strength(float height) { return FAR_SIDE_ONLY != 0 ? max(0.0, height) : abs(height); }
