// SPDX-License-Identifier: Apache-2.0
// The projection of casters onto frame.receiver_plane_world from a view's own point (Blinn 1988), as seen by the camera.

#include "spaces.glsl"

/// The point, or (w = 0) the direction, that a view looks from: homogeneous, world space.
vec4 viewpoint_world(LightViewData view) {
  mat3 rotation = mat3(view.light_from_world);
  if (is_orthographic(view)) return vec4(-transpose(rotation)[2], 0.0);  // towards the light
  vec3 translation = (view.light_from_world * vec4(0.0, 0.0, 0.0, 1.0)).xyz;
  return vec4(-transpose(rotation) * translation, 1.0);
}

/// The plane through the middle of the receivers, with the light on its positive side.
vec4 plane_towards(vec4 viewpoint) {
  vec4 plane = frame.receiver_plane_world;
  return dot(plane, viewpoint) < 0.0 ? -plane : plane;
}

/// The plane's point on the line from `viewpoint` through p_world, homogeneous. Positive w for casters between both.
vec4 projected_world(vec4 plane, vec4 viewpoint, vec3 p_world) {
  vec4 p = vec4(p_world, 1.0);
  return dot(plane, viewpoint) * p - dot(plane, p) * viewpoint;
}

/// Half the thickness of the plane at p_world: plane_offset_px widths of a pixel there, and no less than what positions
/// lose as floats, of which a step is 2^-23 of a coordinate.
float plane_offset_world(vec3 p_world) {
  vec3 up = vec3(frame.clip_from_world[0].y, frame.clip_from_world[1].y, frame.clip_from_world[2].y);
  float depth_view = max((frame.clip_from_world * vec4(p_world, 1.0)).w, 0.0);
  float pixel_world = 2.0 * depth_view / (length(up) * float(frame.screen_and_seed.y));
  return max(plane_offset_px * pixel_world, exp2(-21.0) * length(p_world));  // const: four steps
}
