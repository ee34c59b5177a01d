// SPDX-License-Identifier: Apache-2.0
// The variance of the noise that is left, from moments over frames or, where those are few, over the 7 x 7 pixels around that show
// the same surface (Schied et al. 2017, 4.2).
#include "edge_stopping.glsl"

vec2 moments_around(ivec2 px, Surface surface) {
  const int kReach = 3;  // const: as published
  vec3 sum = vec3(0.0);
  for (int y = -kReach; y <= kReach; ++y) {
    for (int x = -kReach; x <= kReach; ++x) {
      ivec2 near = px + ivec2(x, y);
      if (any(lessThan(near, ivec2(0))) || any(greaterThanEqual(near, frame.screen_and_seed.xy))) continue;
      float weight = surface_weight(surface, surface_at(near));
      sum += weight * vec3(texelFetch(accumulated, near, 0).ba, 1.0);
    }
  }
  return sum.xy / sum.z;
}

void main() {
  ivec2 px = ivec2(gl_FragCoord.xy);
  vec4 here = texelFetch(accumulated, px, 0);
  out_even = vec2(here.r, 0.0);
  Surface surface = surface_at(px);
  if (surface.depth == 0.0) return;
  vec2 moments = here.g < float(short_history) ? moments_around(px, surface) : here.ba;
  out_even.g = max(0.0, moments.y - moments.x * moments.x);
}
