// SPDX-License-Identifier: Apache-2.0
// Visibility and its moments over frames (Schied et al. 2017, 4.1), found again where the surface was in the frame before.
#include "reprojection.glsl"

/// What the frame before left of a point; no frames where its surface was not seen.
vec4 before_of(vec3 p_world, vec3 n_world) {
  Reprojected at = reproject(p_world, n_world);
  vec4 sum = vec4(0.0);
  float weights = 0.0;
  for (int i = 0; i < kAround; ++i) {
    if (at.weights[i] == 0.0) continue;
    vec4 kept = texelFetch(previous_kept, pixel_around(at, i), 0);
    if (kept.g == 0.0) continue;
    sum += at.weights[i] * kept;
    weights += at.weights[i];
  }
  return weights > 0.0 ? sum / weights : vec4(0.0);
}

void main() {
  ivec2 px = ivec2(gl_FragCoord.xy);
  vec4 position = texelFetch(gbuffer_position, px, 0);
  out_accumulated = vec4(1.0, 0.0, 1.0, 1.0);
  if (position.w == 0.0) return;
  float now = texelFetch(current, px, 0).r;
  vec4 before = before_of(position.xyz, texelFetch(gbuffer_normal, px, 0).xyz);
  float frames = min(before.g + 1.0, float(history_frames));
  vec3 mean = mix(vec3(before.r, before.ba), vec3(now, now, now * now), 1.0 / frames);
  out_accumulated = vec4(mean.x, frames, mean.yz);
}
