// SPDX-License-Identifier: Apache-2.0
// What visibility is multiplied by: 0 on surfaces turned away from the light's centre.
#include "volume_light.glsl"

void main() {
  vec4 position = texelFetch(gbuffer_position, ivec2(gl_FragCoord.xy), 0);
  vec3 n_world = texelFetch(gbuffer_normal, ivec2(gl_FragCoord.xy), 0).xyz;
  out_visibility = position.w == 0.0 || dot(n_world, from_light(position.xyz)) < 0.0 ? 1.0 : 0.0;
}
