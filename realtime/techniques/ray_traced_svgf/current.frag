// SPDX-License-Identifier: Apache-2.0
// This frame's rays to the light: to the points after those of the frame before.
#include "r2_sequence.glsl"
#include "shadow_rays.glsl"

float seen_share(vec3 p_world, vec3 n_world) {
  vec2 p_px = pixel_position(gl_FragCoord.xy, float(frame.screen_and_seed.y));
  vec2 offset = r2_offset(seeded_position(p_px, frame.screen_and_seed.z));
  float seen = 0.0;
  for (int i = 0; i < SAMPLES; ++i) {
    if (is_light_seen(p_world, n_world, r2_point(history.frame.x * SAMPLES + i, offset))) seen += 1.0;
  }
  return seen / float(SAMPLES);
}

void main() {
  ivec2 px = ivec2(gl_FragCoord.xy);
  vec4 position = texelFetch(gbuffer_position, px, 0);
  out_current = position.w == 0.0 ? 1.0 : seen_share(position.xyz, texelFetch(gbuffer_normal, px, 0).xyz);
}
