// SPDX-License-Identifier: Apache-2.0
// Exponential shadow maps (Annen et al. 2008; Salvi 2008): the step of a comparison as exp(c (z - z_receiver)), which
// is a product of what the map holds and what the receiver knows.
#include "esm_filter.glsl"
#include "filtered_plane.glsl"
#include "pixel.glsl"

/// Without a blocker the filter holds at least `plane` times exp(c z).
float exponential_visibility(float filtered, float z, float plane) {
  if (FORM == FORM_EXPONENTIAL) return min(1.0, filtered * exp(exponent * (1.0 - z)) / plane);
  return min(1.0, exp(exponent * (filtered - z)) / plane);
}

float visibility_of(Receiver receiver) {
  float known;
  if (is_known(view_light, receiver, known)) return known;
  float z = normalized_distance(view_light, receiver.p_light.z - receiver.bias_world);
  float filtered = bilinear_mean(warped, texel_position(view_light, receiver.lateral));
  float spread_world = plane_spread_world(view_light, receiver, filter_width_texels);
  float spread = normalized_length(view_light, spread_world, receiver.p_light.z);
  if (FORM != FORM_LINEAR_DEPTH) return exponential_visibility(filtered, z, half_plane_exponential(exponent * spread));
  float bias_world = plane_bias_world(view_light, receiver, filter_width_texels);
  float plane_bias = normalized_length(view_light, bias_world, receiver.p_light.z);
  return exponential_visibility(filtered, z - plane_bias, 1.0);
}

/// Two controls that art asks for and light does not.
float styled(float visibility) {
  return max(darkest, darkening == 1.0 ? visibility : pow(visibility, darkening));
}

/// The values from full_shadow_at to 1 over [0,1].
float stretched(float passed) { return max(0.0, passed - full_shadow_at) / (1.0 - full_shadow_at); }

void main() {
  Receiver receiver;
  out_visibility = styled(fetch_receiver(receiver) ? stretched(visibility_of(receiver)) : 1.0);
}
