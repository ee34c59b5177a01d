// SPDX-License-Identifier: Apache-2.0
// Visibility by rays through the map to points of the light, as Unreal Engine 5 finds it: each is compared with the map at places
// along it, from its far end to the receiver. A surface that the ray has passed behind goes on unseen; what was seen beside it
// last stands in for it. For techniques with the parameters of the group map_rays; those that
// take lamps define LAMP_RAYS and have max_ray_angle_rad and lamp_slope.
#include "kernel_light.glsl"
#include "map_ray.glsl"
#include "pixel.glsl"
#include "search_bound.glsl"

/// Noise of ray `index` in [0,1)^2: steps of the sequence of plastic ratios from the pixel's own.
vec2 ray_noise(int index) {
  const vec2 kStep = vec2(0.7548776662466927, 0.5698402909980532);  // const: 1 / p and 1 / p^2, p^3 = p + 1
  vec2 p_px = noise_position();
  vec2 own = vec2(interleaved_gradient_noise(p_px), interleaved_gradient_noise(p_px.yx));
  return fract(own + float(index) * kStep);
}

#ifdef LAMP_RAYS

/// Share of the way to a point of the lamp that Unreal follows: three quarters, less where the ray opens wide.
float share_to_lamp(Receiver receiver, vec3 way) {
  const float kMost = 0.75;   // const: VirtualShadowMapProjectionSpot.ush
  const float kOpens = 1.5;   // const: the same
  vec3 axis = -normalize(receiver.p_light);
  vec3 direction = normalize(way);
  float across = length(cross(axis, direction));
  float opening = dot(axis, direction) + across / tan(max_ray_angle_rad);
  return kMost * clamp(kOpens / opening, 0.0, 1.0) * length(receiver.p_light) / length(way);
}

#endif

float camera_distance_world(Receiver receiver) {
  return distance((view_light.light_from_world * frame.eye_world).xyz, receiver.p_light);
}

/// The part that is followed of `way`, from the receiver to a point of the light (sun: of unit drop).
vec3 followed(AreaLight light, Receiver receiver, vec3 way, float z_search) {
  if (RAY_REACH == RAY_REACH_BLOCKERS) return way * ((z_search - receiver.p_light.z) / way.z);
#ifdef LAMP_RAYS
  if (light.type != kSun) return way * share_to_lamp(receiver, way);
#endif
  return normalize(way) * (sun_length * camera_distance_world(receiver));
}

/// Where a ray begins: the receiver, or another place of its plane, twice as much nearer as that rises.
vec3 ray_start(Receiver receiver, vec2 offset_texels) {
  if (texel_dither == 0.0) return receiver.p_light;
  vec2 texel = (view_light.lateral_bounds.zw - view_light.lateral_bounds.xy) / view_light.depth_range.w;
  vec2 lateral = receiver.lateral + offset_texels * texel;
  float z = 2.0 * plane_distance_at(view_light, receiver, lateral) - receiver.p_light.z;
  return is_orthographic(view_light) ? vec3(lateral, z) : vec3(lateral * z, z);
}

/// Depth that own_texel_bias adds.
float depth_bias(Receiver receiver) {
  vec2 center = lateral_of_texel(view_light, floor(texel_position(view_light, receiver.lateral)) + 0.5);
  float drop = receiver.p_light.z - plane_distance_at(view_light, receiver, center);
  return open_depth(view_light, receiver.p_light.z - own_texel_bias * drop) -
         open_depth(view_light, receiver.p_light.z);
}

/// Share of the rays that nothing stops.
float share_of_rays(Receiver receiver) {
  AreaLight light = kernel_light();
  float z_search = nearest_blocker_bound(light, receiver);
  bool is_open = is_behind(view_light, receiver) || z_search >= receiver.p_light.z;
  float bias = depth_bias(receiver);
  vec3 above = normal_distances * camera_distance_world(receiver) * receiver.n_light;
  float seen = 0.0;
  for (int i = 0; i < RAYS; ++i) {
    vec3 way = ray_to_light(light, receiver, kernel_point(light, i, RAYS, ray_noise(0)));
    if (!faces(receiver, way)) continue;
    if (!is_open && way.z < 0.0) {
      vec2 noise = ray_noise(i + 1);
      vec3 start = ray_start(receiver, texel_dither * (noise - 0.5)) + above;
      MapRay ray = map_ray(view_light, start, followed(light, receiver, way, z_search));
      ray.start.z += bias;
      if (is_stopped(view_light, receiver, ray, noise.x)) continue;
    }
    seen += 1.0;
  }
  return seen / float(RAYS);
}
