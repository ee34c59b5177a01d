// SPDX-License-Identifier: Apache-2.0
// The shaded point as a shadow map sees it, and the depth a tap is compared with (the biases).
#include "spaces.glsl"

const int kNoPlane = 0;              // const: choice receiver_plane
const int kPlaneAtTap = 1;           // const: choice receiver_plane
const int kOffsetBySine = 0;         // const: choice normal_offset_form
const int kOffsetByOneMinusCos = 1;  // const: choice normal_offset_form

/// What a single tap is compared with; see realtime/techniques/shared/bias.toml.
struct TapBias {
  bool is_auto;
  float auto_scale;
  int plane;
  float cone;
};

struct Bias {
  float bias_world;
  float bias_texels;
  float normal_offset_texels;
  int normal_offset_form;
  TapBias taps;
};

struct Receiver {
  vec3 p_light;  // offset along the normal
  vec3 n_light;  // geometric, unit
  vec2 lateral;
  float bias_world;      // all constant terms
  float slope;           // tangent of the light's incidence, limited
  float plane_distance;  // dot(n_light, p_light)
  TapBias taps;
#ifdef BLOCKER_FROM_TRUTH
  ivec2 px;  // GL's rows
#endif
};

// A plane seen nearly edge-on meets the next texel's ray far in front of every blocker: followed without limit it
// lets light through walls. Planes up to 88 degrees are still exact.
const float kMaxPlaneSlope = 50.0;  // const: tangent of the incidence angle, measured (docs/design.md)

float normal_offset_share(float cos_incidence, int form) {
  if (form == kOffsetBySine) return sqrt(max(0.0, 1.0 - cos_incidence * cos_incidence));
  return form == kOffsetByOneMinusCos ? 1.0 - abs(cos_incidence) : 1.0;
}

/// Moves the point along its normal by k texels times the sine of the light's incidence: offsetting by d gains
/// d / cos of depth against the slope's tan per texel, so sin is what a slope needs (TECHNIQUES 2.1, B3).
vec3 offset_along_normal(LightViewData view, vec3 p_light, vec3 n_light, float cos_incidence, Bias bias) {
  float share = normal_offset_share(cos_incidence, bias.normal_offset_form);
  return p_light + n_light * (bias.normal_offset_texels * texel_world(view, p_light.z) * share);
}

float limited_slope(float cos_incidence) {
  float sin_incidence = sqrt(max(0.0, 1.0 - cos_incidence * cos_incidence));
  return sin_incidence < kMaxPlaneSlope * cos_incidence ? sin_incidence / cos_incidence : kMaxPlaneSlope;
}

/// In mode auto the point stays where it is: its slope alone decides.
Receiver make_receiver(LightViewData view, vec3 p_world, vec3 n_world, Bias bias) {
  Receiver receiver;
  vec3 p_light = (view.light_from_world * vec4(p_world, 1.0)).xyz;
  vec3 to_light = is_orthographic(view) ? vec3(0.0, 0.0, -1.0) : -normalize(p_light);
  receiver.n_light = mat3(view.light_from_world) * n_world;
  float cos_incidence = dot(receiver.n_light, to_light);
  receiver.taps = bias.taps;
  receiver.slope = limited_slope(abs(cos_incidence));
  receiver.p_light =
      bias.taps.is_auto ? p_light : offset_along_normal(view, p_light, receiver.n_light, cos_incidence, bias);
  receiver.lateral = lateral_of(view, receiver.p_light);
  receiver.bias_world = bias.bias_world + bias.bias_texels * texel_world(view, p_light.z);
  receiver.plane_distance = dot(receiver.n_light, receiver.p_light);
  return receiver;
}

/// The nearest distance that the limited slope allows on the light's ray through `lateral`.
float nearest_plane_distance(LightViewData view, Receiver receiver, vec2 lateral) {
  if (is_orthographic(view)) return receiver.p_light.z - kMaxPlaneSlope * distance(lateral, receiver.lateral);
  vec3 ray = vec3(lateral, 1.0);
  float along_ray = dot(receiver.p_light, ray) - kMaxPlaneSlope * length(cross(receiver.p_light, ray));
  return along_ray / dot(ray, ray);
}

/// Distance at which the light's ray through `lateral` meets the receiver's tangent plane, within the limited slope.
/// Exact for planes: perspective z = n.p / n.(l, 1), orthographic z = (n.p - n.(l, 0)) / n.z (Dou et al. 2014;
/// TECHNIQUES 2.1, B6).
float surface_distance_at(LightViewData view, Receiver receiver, vec2 lateral) {
  vec3 n = receiver.n_light;
  bool ortho = is_orthographic(view);
  float numerator = receiver.plane_distance - (ortho ? dot(n.xy, lateral) : 0.0);
  float denominator = n.z + (ortho ? 0.0 : dot(n.xy, lateral));
  float z = denominator == 0.0 ? -1.0 : numerator / denominator;
  bool meets = ortho ? denominator != 0.0 : z > 0.0;
  if (!meets) return receiver.p_light.z;
  float z_nearest = nearest_plane_distance(view, receiver, lateral);
  return clamp(z, z_nearest, max(z_nearest, 2.0 * receiver.p_light.z - z_nearest));
}

/// The same but never beyond the receiver itself, because a blocker is always nearer to the light than what it shadows.
float plane_distance_at(LightViewData view, Receiver receiver, vec2 lateral) {
  return min(surface_distance_at(view, receiver, lateral), receiver.p_light.z);
}

/// Whether taps are compared with the tangent plane, one way or the other.
bool compares_plane(Receiver receiver) {
  return !receiver.taps.is_auto && receiver.taps.plane != kNoPlane;
}

/// World distance, at the receiver's depth, between its own ray and the light's ray through `lateral`.
float distance_off_ray(LightViewData view, Receiver receiver, vec2 lateral) {
  return distance(lateral, receiver.lateral) * (is_orthographic(view) ? 1.0 : receiver.p_light.z);
}

/// Tangent of the half angle under which the receiver sees the light; rect: of its mean half extent.
float tan_light_angle(LightViewData view, Receiver receiver) {
  float half_extent = 0.5 * (frame.light_extent.x + frame.light_extent.y);
  return is_orthographic(view) ? half_extent : half_extent / receiver.p_light.z;
}

/// The tangent plane where a filter's tap lies, which keeps the receiver's place within its texel, less the half
/// texel by which the map was sampled elsewhere (TECHNIQUES 2.1, B4).
float plane_distance_of_tap(LightViewData view, Receiver receiver, vec2 lateral_center) {
  vec2 own_center = lateral_of_texel(view, floor(texel_position(view, receiver.lateral)) + 0.5);
  float half_texel = 0.5 * sqrt(2.0) * texel_world(view, receiver.p_light.z) * receiver.slope;
  return plane_distance_at(view, receiver, receiver.lateral + lateral_center - own_center) - half_texel;
}

float manual_distance(LightViewData view, Receiver receiver, vec2 lateral_center) {
  float z = receiver.p_light.z;
  if (receiver.taps.plane == kPlaneAtTap) {
    z = plane_distance_of_tap(view, receiver, lateral_center);
  } else if (receiver.taps.plane != kNoPlane) {
    z = plane_distance_at(view, receiver, lateral_center);
  }
  if (receiver.taps.cone > 0.0) {
    z -= receiver.taps.cone * distance_off_ray(view, receiver, lateral_center) /
         tan_light_angle(view, receiver);
  }
  return z - receiver.bias_world;
}

/// What the stored distance of the texel with its centre at `lateral_center` must reach for the receiver to be lit.
float compare_distance(LightViewData view, Receiver receiver, vec2 lateral_center) {
  if (!receiver.taps.is_auto) return manual_distance(view, receiver, lateral_center);
  const float kRounding = 0.1;  // const: texels; surfaces that face the light have no slope but still round
  float texel = texel_world(view, receiver.p_light.z);
  float reach_world = distance_off_ray(view, receiver, lateral_center) + texel;
  return receiver.p_light.z - receiver.taps.auto_scale * (receiver.slope * reach_world + kRounding * texel);
}

/// Whether the receiver's surface faces a point of light space (orthographic: a direction towards the light).
bool faces(Receiver receiver, vec3 to_light) {
  return dot(receiver.n_light, to_light) > 0.0;
}

/// From the receiver to the view's own viewpoint.
vec3 to_viewpoint(LightViewData view, Receiver receiver) {
  return is_orthographic(view) ? vec3(0.0, 0.0, -1.0) : -receiver.p_light;
}

/// Whether the receiver lies behind a perspective view, outside any map.
bool is_behind(LightViewData view, Receiver receiver) {
  return !is_orthographic(view) && receiver.p_light.z <= 0.0;
}

/// The answers that need no map: 0 on surfaces turned away from the viewpoint, 1 behind the view.
bool is_known(LightViewData view, Receiver receiver, out float visibility) {
  bool is_turned_away = !faces(receiver, to_viewpoint(view, receiver));
  visibility = is_turned_away ? 0.0 : 1.0;
  return is_turned_away || is_behind(view, receiver);
}
