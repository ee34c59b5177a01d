// SPDX-License-Identifier: Apache-2.0
// Six-moment shadow maps (Peters et al. 2017) over maps that were blurred once.
#include "blended_tap.glsl"
#include "moments.glsl"
#include "pixel.glsl"
#include "six_moments.glsl"

#include "hamburger_six.glsl"

Moments held_at(vec2 uv) {
  vec2 low = texture(moments_low, uv).xy;
  vec2 middle = texture(moments_middle, uv).xy;
  vec2 high = texture(moments_high, uv).xy;
  return Moments(vec3(low.x, middle.x, high.x), vec3(low.y, middle.y, high.y));
}

/// Without what the bias itself can put before the receiver: all of it at most.
float blocked_share(Moments m, float t) {
  return clamp((least_share_before(biased(m, moment_bias), t) - moment_bias) / (1.0 - moment_bias), 0.0, 1.0);
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
  if (any(lessThan(p_texels, vec2(0.0))) || any(greaterThan(p_texels, moments_low_size.xy))) return 1.0;
  float z = least_plane_distance(receiver) - receiver.bias_world;
  float t = 2.0 * normalized_distance(view_light, z) - 1.0;
  float blocked = blocked_share(decoded(held_at(p_texels * moments_low_size.zw)), t);
  return without_bleeding(1.0 - blocked, bleed_reduction);
}

void main() {
  Receiver receiver;
  out_visibility = fetch_receiver(receiver) ? visibility_of(receiver) : 1.0;
}
