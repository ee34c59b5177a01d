// SPDX-License-Identifier: Apache-2.0
// Percentage-closer soft shadows whose filter averages moments: the blocker search of pcss, then Chebyshev's bound for
// the mean of the moments over the penumbra (Fernando 2005; Donnelly and Lauritzen 2006).
#include "blocker_search.glsl"
#include "light_kernel.glsl"
#include "pixel.glsl"
#include "variance_bound.glsl"

/// Moments at one place of the map, as if the receiver's tangent plane were at the receiver's distance everywhere.
vec2 moments_at(Receiver receiver, vec2 lateral) {
  vec2 read = texture(moments, texel_position(view_light, lateral) * moments_size.zw).rg;
  if (!compares_plane(receiver)) return read;
  float drop = receiver.p_light.z - surface_distance_at(view_light, receiver, lateral);
  return shifted_moments(read, normalized_length(view_light, drop, receiver.p_light.z));
}

/// Share of the light above the horizon, times the share of it that the moments let pass.
float filtered_visibility(AreaLight light, Receiver receiver, float z_blocker, vec2 noise) {
  bool has_blocker = z_blocker < receiver.p_light.z;
  vec2 sum = vec2(0.0);
  float facing = 0.0;
  for (int i = 0; i < tap_count(FILTER_TAPS); ++i) {
    vec2 kernel = kernel_tap(light, i, FILTER_TAPS, noise);
    vec3 ray = ray_to_light(light, receiver, kernel);
    if (!faces(receiver, ray)) continue;
    facing += 1.0;
    vec2 lateral = ray.z < 0.0 ? filter_lateral(light, view_light, receiver, kernel, ray, z_blocker) : receiver.lateral;
    if (has_blocker) sum += moments_at(receiver, lateral);
  }
  float share = facing / float(tap_count(FILTER_TAPS));
  return has_blocker && facing > 0.0 ? share * variance_visibility(view_light, receiver, sum / facing) : share;
}

float visibility_of(Receiver receiver) {
  AreaLight light = kernel_light();
  vec2 noise = kernel_noise(noise_position());
  float z_blocker = mean_blocker_distance(light, receiver, noise, view_light.depth_range.x);
  float visibility = filtered_visibility(light, receiver, z_blocker, noise);
  return CONTRAST != 0 ? smoothstep(0.0, 1.0, visibility) : visibility;
}

void main() {
  Receiver receiver;
  out_visibility = fetch_receiver(receiver) ? visibility_of(receiver) : 1.0;
}
