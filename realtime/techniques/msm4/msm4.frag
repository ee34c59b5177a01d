// SPDX-License-Identifier: Apache-2.0
// Moment shadow maps (Peters and Klein 2015) over a map that was blurred once.
#include "blended_tap.glsl"
#include "four_moments.glsl"
#include "hamburger.glsl"
#include "moments.glsl"
#include "pixel.glsl"

/// Of the bias distribution, half of its even moments at either end and the rest in the middle.
float bias_share_before(float t) { return 0.5 * bias_even_moments + (t > 0.0 ? 1.0 - bias_even_moments : 0.0); }

/// Without what the bias itself puts before the receiver.
float blocked_share(vec4 m, float t) {
  vec4 biased = mix(m, vec4(0.0, bias_even_moments, 0.0, bias_even_moments), moment_bias);
  float share = least_share_before(biased, t);
  return clamp((share - moment_bias * bias_share_before(t)) / (1.0 - moment_bias), 0.0, 1.0);
}

/// The least distance that the blur and the bilinear read can hold of the receiver's own plane, as steep as is lit at most.
float least_plane_distance(Receiver receiver) {
  float z = receiver.p_light.z;
  float reach_texels = 0.5 * (max(filter_width_texels, 1.0) + 1.0);
  float limit_world = steepest_lit * reach_texels * sqrt(2.0) * texel_world(view_light, z);  // along a diagonal
  return max(nearest_within(view_light, receiver, z, reach_texels), z - limit_world);
}

float visibility_of(Receiver receiver) {
  float known;
  if (is_known(view_light, receiver, known)) return known;
  vec2 p_texels = texel_position(view_light, receiver.lateral);
  if (any(lessThan(p_texels, vec2(0.0))) || any(greaterThan(p_texels, moments_size.xy))) return 1.0;
  float z = least_plane_distance(receiver) - receiver.bias_world;
  float t = 2.0 * normalized_distance(view_light, z) - 1.0;
  vec4 m = decoded(texture(moments, p_texels * moments_size.zw));
  return without_bleeding(1.0 - blocked_share(m, t), bleed_reduction);
}

void main() {
  Receiver receiver;
  out_visibility = fetch_receiver(receiver) ? visibility_of(receiver) : 1.0;
}
