// SPDX-License-Identifier: Apache-2.0
// Computed pixels as they are; the others from their computed neighbours, those at the same distance most. For techniques
// with the parameters of the group fill.
#include "checkerboard.glsl"

const float kBackgroundRatio = 1e6;  // const: as far from every surface

/// Distance along the camera's axis; 0 on the background.
float camera_distance(ivec2 px) {
  vec4 position = texelFetch(gbuffer_position, flipped(px, frame.screen_and_seed.y), 0);
  return position.w == 0.0 ? 0.0 : (frame.clip_from_world * vec4(position.xyz, 1.0)).w;
}

/// Difference of distance b from a in the unit of the weights.
float depth_difference(float a, float b) {
  if (a == 0.0 || b == 0.0) return a == b ? 0.0 : kBackgroundRatio;
  return abs(a - b) / (a * fill_depth_ratio);
}

float filled(ivec2 px) {
  ivec2 size = frame.screen_and_seed.xy;
  float distance_px = camera_distance(px);
  float sum = 0.0;
  float total = 0.0;
  float smallest = 2.0 * kBackgroundRatio;
  float nearest = 1.0;
  for (int i = 0; i < 9; ++i) {  // const: the pixel and its neighbours
    ivec2 neighbour = px + ivec2(i % 3, i / 3) - 1;  // const: three in a row
    bool is_inside = all(greaterThanEqual(neighbour, ivec2(0))) && all(lessThan(neighbour, size));
    if (!is_inside || !is_computed(neighbour)) continue;
    float value = texelFetch(packed_visibility, cell_of(neighbour), 0).r;
    float difference = depth_difference(distance_px, camera_distance(neighbour));
    float weight = difference < kBackgroundRatio ? 1.0 / (1e-3 + difference) : 0.0;  // const: as published
    sum += weight * value;
    total += weight;
    if (difference < smallest) nearest = value;
    smallest = min(smallest, difference);
  }
  if (total >= 1.0) return sum / total;
  return FILL == FILL_PAPER ? 0.0 : nearest;
}

void main() {
  ivec2 px = flipped(ivec2(gl_FragCoord.xy), frame.screen_and_seed.y);
  out_visibility = is_computed(px) ? texelFetch(packed_visibility, cell_of(px), 0).r : filled(px);
}
