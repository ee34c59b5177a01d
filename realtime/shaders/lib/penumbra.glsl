// SPDX-License-Identifier: Apache-2.0
// Where search and filter taps read the map: on the rays to the light, or by the squared curve of the group
// penumbra_curve, for techniques that have it.
#include "area_light.glsl"

#ifdef PENUMBRA_CURVE
const bool kHasSquaredPenumbra = PENUMBRA_CURVE == PENUMBRA_CURVE_SQUARED;

/// A length at the receiver in lateral coordinates.
float lateral_of_length(LightViewData view, Receiver receiver, float length_world) {
  return is_orthographic(view) ? length_world : length_world / receiver.p_light.z;
}

/// 0 at the contact, at most 1 (Sterna 2018).
float squared_penumbra(float z_receiver, float z_blocker) {
  float ratio = (z_receiver - z_blocker) / z_blocker;
  return min(1.0, squared_scale * ratio * ratio);
}

vec2 squared_lateral(LightViewData view, Receiver receiver, vec2 kernel, float penumbra) {
  return receiver.lateral + kernel * lateral_of_length(view, receiver, squared_radius_world * penumbra);
}
#endif

/// Where the tap for the light point `kernel`, seen along `ray`, looks for blockers no nearer to the light than
/// `z_search`: all of them lie on its rays from there to the receiver.
vec2 search_lateral(LightViewData view, Receiver receiver, vec2 kernel, vec3 ray, float z_search) {
#ifdef PENUMBRA_CURVE
  if (kHasSquaredPenumbra) return squared_lateral(view, receiver, kernel, 1.0);
#endif
  return lateral_on_ray(view, receiver, ray, z_search);
}

/// Where it is compared, for blockers at the mean distance `z_blocker`.
vec2 filter_lateral(LightViewData view, Receiver receiver, vec2 kernel, vec3 ray, float z_blocker) {
#ifdef PENUMBRA_CURVE
  if (kHasSquaredPenumbra) {
    return squared_lateral(view, receiver, kernel, squared_penumbra(receiver.p_light.z, z_blocker));
  }
#endif
  return lateral_on_ray(view, receiver, ray, z_blocker);
}
