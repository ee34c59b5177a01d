// SPDX-License-Identifier: Apache-2.0
// Percentage-closer filtering as comparison samplers do it: one reference depth a read.
#include "blended_tap.glsl"
#include "pixel.glsl"

#ifdef linear_map_size
const float kReachTexels = 1.0;  // const: per axis, to the farthest of four texels
float compared(vec3 uv_depth) { return texture(linear_map, uv_depth); }
#else
const float kReachTexels = 0.5;  // const: to the middle of the texel
float compared(vec3 uv_depth) { return texture(nearest_map, uv_depth); }
#endif

/// What the read at `p_texels` is compared with.
float reference_distance(Receiver receiver, vec2 p_texels) {
  float z = receiver.p_light.z;
  if (TAP_PLANE != 0) {
    z = plane_distance_at(view_light, receiver, lateral_of_texel(view_light, p_texels));
    z = nearest_within(view_light, receiver, z, kReachTexels);
  }
  return z - receiver.bias_world;
}

float grid_mean(Receiver receiver) {
  vec2 first = texel_position(view_light, receiver.lateral) - 0.5 * float(GRID_TAPS - 1);
  float lit = 0.0;
  for (int i = 0; i < GRID_TAPS * GRID_TAPS; ++i) {
    vec2 p_texels = first + vec2(i % GRID_TAPS, i / GRID_TAPS);
    float depth = depth_of_distance(view_light, reference_distance(receiver, p_texels));
    lit += compared(vec3(p_texels / view_light.depth_range.w, depth));
  }
  return lit / float(GRID_TAPS * GRID_TAPS);
}

float visibility_of(Receiver receiver) {
  float known;
  return is_known(view_light, receiver, known) ? known : grid_mean(receiver);
}

void main() {
  Receiver receiver;
  out_visibility = fetch_receiver(receiver) ? visibility_of(receiver) : 1.0;
}
