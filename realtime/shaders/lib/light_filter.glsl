// SPDX-License-Identifier: Apache-2.0
// The share of the light's points whose rays pass the map, for techniques with the parameters of the group
// light_filter.
#include "light_kernel.glsl"
#include "penumbra.glsl"
#include "shadow_map.glsl"

#ifdef FILTER_CONE

/// Before this distance, on the way to the light, a blocker at the tap of `kernel` is met by some ray to the light:
/// rays at that place of the map run between the receiver and `z_blocker` (TECHNIQUES 2.13). Linear in 1/z for a
/// perspective view as the kernels are.
float cone_distance(AreaLight light, LightViewData view, Receiver receiver, vec2 kernel, float z_blocker) {
  float z_receiver = receiver.p_light.z;
  float share = cone_fraction * kernel_radius(light, kernel);
  float z_cone = is_orthographic(view) ? mix(z_receiver, z_blocker, share)
                                       : 1.0 / mix(1.0 / z_receiver, 1.0 / z_blocker, share);
  return max(z_cone, mix(z_receiver, z_blocker, max_offset));
}

#endif

/// What the map lets pass of the tap: 0 or 1, or with bilinear_taps a share.
float tap_lit(AreaLight light, Receiver receiver, vec2 kernel, vec3 ray, float z_blocker) {
  vec2 lateral = filter_lateral(light, view_light, receiver, kernel, ray, z_blocker);
#ifdef BILINEAR_TAPS
  if (BILINEAR_TAPS != 0) return bilinear_lit(shadow_map, view_light, receiver, texel_position(view_light, lateral));
#endif
  vec2 lateral_met;
  float z_met;
  bool is_met = find_blocker_at(shadow_map, view_light, receiver, lateral, lateral_met, z_met);
#ifdef FILTER_CONE
  if (FILTER_CONE != 0 && is_met) is_met = z_met < cone_distance(light, view_light, receiver, kernel, z_blocker);
#endif
  return is_met ? 0.0 : 1.0;
}

/// Share of the light's points whose rays pass the map at `z_blocker`, all of them where there is no blocker; those below
/// the receiver's horizon do not.
float visible_share(AreaLight light, Receiver receiver, float z_blocker, bool has_blocker, vec2 noise) {
  float seen = 0.0;
  int taps = tap_count(FILTER_TAPS);
  for (int i = 0; i < taps; ++i) {
    if (i == early_tap_count(FILTER_TAPS) && (seen == 0.0 || seen == float(i))) {
      taps = i;
      break;
    }
    vec2 kernel = kernel_tap(light, i, FILTER_TAPS, noise);
    vec3 ray = ray_to_light(light, receiver, kernel);
    if (!faces(receiver, ray)) continue;
    seen += !has_blocker || ray.z >= 0.0 ? 1.0 : tap_lit(light, receiver, kernel, ray, z_blocker);
  }
  float share = seen / float(taps);
  return has_blocker ? with_falloff(view_light, share, receiver.p_light.z, z_blocker) : share;
}
