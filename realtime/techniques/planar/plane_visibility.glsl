// SPDX-License-Identifier: Apache-2.0
#include "projection.glsl"

/// What the projection in `lit` says about this pixel: 1 off the plane, which it does not know; 0 behind the surface.
float plane_visibility(LightViewData view) {
  ivec2 px = ivec2(gl_FragCoord.xy);
  vec4 position = texelFetch(gbuffer_position, px, 0);
  if (position.w == 0.0) return 1.0;
  vec4 viewpoint = viewpoint_world(view);
  vec3 n_world = texelFetch(gbuffer_normal, px, 0).xyz;
  vec3 to_light = viewpoint.w == 0.0 ? viewpoint.xyz : viewpoint.xyz - position.xyz;
  if (dot(n_world, to_light) <= 0.0) return 0.0;
  float height = abs(dot(frame.receiver_plane_world, vec4(position.xyz, 1.0)));
  bool is_on_plane = height <= plane_offset_world(position.xyz);
  return is_on_plane ? texelFetch(lit, px, 0).r : 1.0;
}
