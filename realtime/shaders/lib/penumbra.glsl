// SPDX-License-Identifier: Apache-2.0
// Where search and filter taps read the map: on the rays to the light, or by a curve of the group penumbra_curve, for
// techniques that have it.
#include "area_light.glsl"

#ifdef PENUMBRA_CURVE
const bool kHasCurve = PENUMBRA_CURVE != PENUMBRA_CURVE_PHYSICAL;

/// Width of the map in lateral coordinates; the wider side.
float map_lateral(LightViewData view) { return texel_lateral(view) * view.depth_range.w; }

float range_of_distances(LightViewData view) { return view.depth_range.y - view.depth_range.x; }

/// A distance counted from the curve's camera.
float curve_distance(LightViewData view, float distance_world) {
  if (!is_orthographic(view)) return distance_world;
  const float kNearestCamera = 1e-3;  // const: map widths; casters behind the camera lie before it
  float width_world = map_lateral(view);
  float middle_world = 0.5 * (view.depth_range.x + view.depth_range.y);
  return max(distance_world - middle_world + curve_camera * width_world, kNearestCamera * width_world);
}

/// (z_r - z_b) / z_b, or z_r - z_b in ranges of the map.
float curve_drop(LightViewData view, float z_receiver, float z_blocker) {
  if (PENUMBRA_CURVE == PENUMBRA_CURVE_DIFFERENCE) return (z_receiver - z_blocker) / range_of_distances(view);
  float blocker = curve_distance(view, z_blocker);
  return (curve_distance(view, z_receiver) - blocker) / blocker;
}

/// Radius of the filter in curve_radius.
float curve_value(LightViewData view, float z_receiver, float z_blocker) {
  float drop = max(0.0, curve_drop(view, z_receiver, z_blocker));
  float value = PENUMBRA_CURVE == PENUMBRA_CURVE_SQUARED ? drop * drop : drop;
  return clamp(curve_scale * value + curve_offset, curve_least, curve_most);
}

/// The blocker's distance whose curve_value is `value`.
float curve_blocker_distance(LightViewData view, float z_receiver, float value) {
  float drop = max(0.0, value - curve_offset) / curve_scale;
  if (PENUMBRA_CURVE == PENUMBRA_CURVE_DIFFERENCE) return z_receiver - drop * range_of_distances(view);
  if (PENUMBRA_CURVE == PENUMBRA_CURVE_SQUARED) drop = sqrt(drop);
  float receiver = curve_distance(view, z_receiver);
  return z_receiver - receiver * drop / (1.0 + drop);
}

/// What curve_radius and curve_search count, in lateral coordinates.
vec2 curve_base_lateral(AreaLight light, LightViewData view, float z_receiver) {
  if (CURVE_BASE == CURVE_BASE_MAP) return vec2(light.scale * map_lateral(view));
  return light.half_extent * (is_orthographic(view) ? curve_distance(view, z_receiver) : 1.0 / z_receiver);
}
#endif

/// Where the tap for the light point `kernel`, seen along `ray`, looks for blockers no nearer to the light than
/// `z_search`: all of them lie on its rays from there to the receiver.
vec2 search_lateral(AreaLight light, LightViewData view, Receiver receiver, vec2 kernel, vec3 ray, float z_search) {
#if defined(PENUMBRA_CURVE) && defined(SEARCH_TAPS)
  if (kHasCurve)
    return receiver.lateral + curve_search * curve_base_lateral(light, view, receiver.p_light.z) * kernel;
#endif
  return lateral_on_ray(view, receiver, ray, z_search);
}

/// Where it is compared, for blockers at the mean distance `z_blocker`.
vec2 filter_lateral(AreaLight light, LightViewData view, Receiver receiver, vec2 kernel, vec3 ray, float z_blocker) {
#ifdef PENUMBRA_CURVE
  if (kHasCurve) {
    float radius = curve_radius * curve_value(view, receiver.p_light.z, z_blocker);
    return receiver.lateral + radius * curve_base_lateral(light, view, receiver.p_light.z) * kernel;
  }
#endif
  return lateral_on_ray(view, receiver, ray, z_blocker);
}

/// A visible share as a curve lightens it with the distance of its blocker.
float with_falloff(LightViewData view, float share, float z_receiver, float z_blocker) {
#ifdef PENUMBRA_CURVE
  if (kHasCurve)
    return mix(share, 1.0, clamp(curve_falloff * (z_receiver - z_blocker) / range_of_distances(view), 0.0, 1.0));
#endif
  return share;
}
