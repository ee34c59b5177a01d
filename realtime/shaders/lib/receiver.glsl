// The shaded point as a shadow map sees it, and the depth a tap is compared with (the biases).
#include "spaces.glsl"

/// Parameters of the group "bias"; see realtime/techniques/shared/bias.toml.
struct Bias {
  float bias_world;
  float bias_texels;
  float normal_offset_texels;
  bool receiver_plane;
};

struct Receiver {
  vec3 p_light;  // offset along the normal
  vec3 n_light;  // geometric, unit
  vec2 lateral;
  float bias_world;          // all constant terms
  bool has_plane;            // compare with the tangent plane instead of p_light.z
  float plane_distance;      // dot(n_light, p_light)
};

/// Moves the point along its normal by k texels times the sine of the light's incidence: offsetting by d gains
/// d / cos of depth against the slope's tan per texel, so sin is what a slope needs (TECHNIQUES 2.1, B3).
vec3 offset_along_normal(LightViewData view, vec3 p_light, vec3 n_light, float normal_offset_texels) {
  vec3 to_light = is_orthographic(view) ? vec3(0.0, 0.0, -1.0) : -normalize(p_light);
  float cos_incidence = dot(n_light, to_light);
  float sin_incidence = sqrt(max(0.0, 1.0 - cos_incidence * cos_incidence));
  return p_light + n_light * (normal_offset_texels * texel_world(view, p_light.z) * sin_incidence);
}

Receiver make_receiver(LightViewData view, vec3 p_world, vec3 n_world, Bias bias) {
  Receiver receiver;
  vec3 p_light = (view.light_from_world * vec4(p_world, 1.0)).xyz;
  receiver.n_light = mat3(view.light_from_world) * n_world;
  receiver.p_light = offset_along_normal(view, p_light, receiver.n_light, bias.normal_offset_texels);
  receiver.lateral = lateral_of(view, receiver.p_light);
  receiver.bias_world = bias.bias_world + bias.bias_texels * texel_world(view, p_light.z);
  receiver.has_plane = bias.receiver_plane;
  receiver.plane_distance = dot(receiver.n_light, receiver.p_light);
  return receiver;
}

// A plane seen nearly edge-on meets the next texel's ray far in front of every blocker: followed without limit it
// lets light through walls. Planes up to 88 degrees are still exact.
const float kMaxPlaneSlope = 50.0;  // const: tangent of the incidence angle, measured (docs/design.md)

/// The nearest distance that the limited slope allows on the light's ray through `lateral`.
float nearest_plane_distance(LightViewData view, Receiver receiver, vec2 lateral) {
  if (is_orthographic(view)) return receiver.p_light.z - kMaxPlaneSlope * distance(lateral, receiver.lateral);
  vec3 ray = vec3(lateral, 1.0);
  float along_ray = dot(receiver.p_light, ray) - kMaxPlaneSlope * length(cross(receiver.p_light, ray));
  return along_ray / dot(ray, ray);
}

/// Distance at which the light's ray through `lateral` meets the receiver's tangent plane; never beyond the
/// receiver itself, because a blocker is always nearer to the light than what it shadows. Exact for planes:
/// perspective z = n.p / n.(l, 1), orthographic z = (n.p - n.(l, 0)) / n.z (Dou et al. 2014; TECHNIQUES 2.1, B6).
float plane_distance_at(LightViewData view, Receiver receiver, vec2 lateral) {
  vec3 n = receiver.n_light;
  bool ortho = is_orthographic(view);
  float numerator = receiver.plane_distance - (ortho ? dot(n.xy, lateral) : 0.0);
  float denominator = n.z + (ortho ? 0.0 : dot(n.xy, lateral));
  float z = denominator == 0.0 ? -1.0 : numerator / denominator;
  bool meets = ortho ? denominator != 0.0 : z > 0.0;
  if (!meets) return receiver.p_light.z;
  return min(max(z, nearest_plane_distance(view, receiver, lateral)), receiver.p_light.z);
}

/// What the stored distance at `lateral` must reach for the receiver to be lit.
float compare_distance(LightViewData view, Receiver receiver, vec2 lateral) {
  float z = receiver.has_plane ? plane_distance_at(view, receiver, lateral) : receiver.p_light.z;
  return z - receiver.bias_world;
}

/// Whether the receiver's surface faces a point of light space (orthographic: a direction towards the light).
bool faces(Receiver receiver, vec3 to_light) { return dot(receiver.n_light, to_light) > 0.0; }

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
