// SPDX-License-Identifier: Apache-2.0
// Percentage-closer soft shadows whose filter averages exponentials: the blocker search of pcss, then the mean of
// exp(c (z - z_receiver)) over the penumbra (Fernando 2005; Annen et al. 2008).
#include "blocker_search.glsl"
#include "light_kernel.glsl"
#include "moments.glsl"
#include "pixel.glsl"

/// Normalised distance that a tap at `lateral` is compared with.
float reference_distance(Receiver receiver, vec2 lateral) {
  float z = compares_plane(receiver) ? surface_distance_at(view_light, receiver, lateral) : receiver.p_light.z;
  return normalized_distance(view_light, z - receiver.bias_world);
}

/// What a tap adds to the mean: exp(c (z - z_receiver)), or only z - z_receiver for the linear form.
float tap_value(Receiver receiver, vec2 lateral) {
  float stored = texture(warped, texel_position(view_light, lateral) * warped_size.zw).r;
  float z = reference_distance(receiver, lateral);
  if (FORM == FORM_LINEAR_DEPTH) return stored - z;
  float passed = stored * exp(exponent * (1.0 - z));
  return CLAMP == CLAMP_TAPS ? min(1.0, passed) : passed;
}

/// What the mean lets pass, with the values from full_shadow_at to 1 over [0,1].
float passed_share(float mean) {
  float passed = min(1.0, FORM == FORM_LINEAR_DEPTH ? exp(exponent * min(0.0, mean)) : mean);
  return max(0.0, passed - full_shadow_at) / (1.0 - full_shadow_at);
}

/// Share of the light above the horizon, times the share of it that the map lets pass.
float filtered_visibility(AreaLight light, Receiver receiver, float z_blocker, vec2 noise) {
  bool has_blocker = z_blocker < receiver.p_light.z;
  float sum = 0.0;
  float facing = 0.0;
  for (int i = 0; i < tap_count(FILTER_TAPS); ++i) {
    vec2 kernel = kernel_tap(light, i, FILTER_TAPS, noise);
    vec3 ray = ray_to_light(light, receiver, kernel);
    if (!faces(receiver, ray)) continue;
    facing += 1.0;
    vec2 lateral = ray.z < 0.0 ? filter_lateral(light, view_light, receiver, kernel, ray, z_blocker) : receiver.lateral;
    if (has_blocker) sum += tap_value(receiver, lateral);
  }
  if (facing == 0.0) return 0.0;
  float passed = has_blocker ? max(passed_share(sum / facing), darkest) : 1.0;
  return facing / float(tap_count(FILTER_TAPS)) * passed;
}

float visibility_of(Receiver receiver) {
  AreaLight light = kernel_light();
  vec2 noise = kernel_noise(noise_position());
  float z_blocker = mean_blocker_distance(light, receiver, noise, view_light.depth_range.x);
  return filtered_visibility(light, receiver, z_blocker, noise);
}

void main() {
  Receiver receiver;
  out_visibility = fetch_receiver(receiver) ? visibility_of(receiver) : 1.0;
}
