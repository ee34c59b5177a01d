// SPDX-License-Identifier: Apache-2.0
#include "projection.glsl"

layout(location = 0) in vec3 p_world;

/// Clips what lies in or below the plane, and what lies beyond the light, whose projection would be an anti-shadow.
void project_from(LightViewData view) {
  vec4 viewpoint = viewpoint_world(view);
  vec4 plane = plane_towards(viewpoint);
  float height = dot(plane, vec4(p_world, 1.0));
  gl_ClipDistance[0] = height - plane_offset_world(p_world);
  gl_ClipDistance[1] = viewpoint.w == 0.0 ? 1.0 : dot(plane, viewpoint) - height;
  gl_Position = frame.clip_from_world * projected_world(plane, viewpoint, p_world);
}
