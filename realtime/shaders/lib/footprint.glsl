// SPDX-License-Identifier: Apache-2.0
// What a pixel covers of a light's map. From the receiver's plane, not from neighbouring pixels: those may show another
// surface.
#include "spaces.glsl"

/// Where the camera's ray through a place of the screen (frag_coord) meets a plane.
vec3 plane_point_world(vec2 frag_coord, vec3 p_world, vec3 n_world) {
  vec2 ndc = 2.0 * frag_coord / vec2(frame.screen_and_seed.xy) - 1.0;
  vec4 near = inverse(frame.clip_from_world) * vec4(ndc, 1.0, 1.0);
  vec3 eye = frame.eye_world.xyz;
  vec3 ray = near.xyz / near.w - eye;
  float along = dot(n_world, ray);
  return along == 0.0 ? p_world : eye + ray * (dot(n_world, p_world - eye) / along);
}

/// Change of the map's coordinates, in [0,1], from this pixel to the one beside or above it.
vec2 uv_change(LightViewData view, vec3 p_world, vec3 n_world, vec2 to_pixel) {
  vec3 q_world = plane_point_world(gl_FragCoord.xy + to_pixel, p_world, n_world);
  vec2 from = lateral_of(view, (view.light_from_world * vec4(p_world, 1.0)).xyz);
  vec2 to = lateral_of(view, (view.light_from_world * vec4(q_world, 1.0)).xyz);
  return (to - from) / (view.lateral_bounds.zw - view.lateral_bounds.xy);
}
