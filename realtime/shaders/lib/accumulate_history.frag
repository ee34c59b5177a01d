// SPDX-License-Identifier: Apache-2.0
// The mean of this frame's visibility, `current`, and of earlier frames', found again where the surface was then, for techniques
// with the parameters of the group history.
#include "reprojection.glsl"

struct History {
  float visibility;
  float frames;  // that its mean is of; 0: none
};

/// What the frame before left of a point, blended over those of the four pixels around it that showed its surface.
History history_of(vec3 p_world, vec3 n_world) {
  Reprojected at = reproject(p_world, n_world);
  vec3 sum = vec3(0.0);
  for (int i = 0; i < kAround; ++i) {
    if (at.weights[i] == 0.0) continue;
    vec2 before = texelFetch(previous_mean, pixel_around(at, i), 0).rg;
    if (before.g > 0.0) sum += at.weights[i] * vec3(before, 1.0);
  }
  return sum.z > 0.0 ? History(sum.x / sum.z, sum.y / sum.z) : History(1.0, 0.0);
}

/// Within what the 3 x 3 pixels around this one show now: their range (Karis 2014), or so many of their standard deviations
/// around their mean (Salvi 2016).
float limited(float visibility) {
  if (HISTORY_LIMIT == HISTORY_LIMIT_NONE) return visibility;
  ivec2 px = ivec2(gl_FragCoord.xy);
  const int kSide = 3;                 // const: as published
  const float kPixels = float(kSide * kSide);
  float low = 1.0, high = 0.0, sum = 0.0, sum_squares = 0.0;
  for (int i = 0; i < kSide * kSide; ++i) {
    ivec2 near = clamp(px + ivec2(i % kSide, i / kSide) - 1, ivec2(0), frame.screen_and_seed.xy - 1);
    float v = texelFetch(current, near, 0).r;
    low = min(low, v), high = max(high, v), sum += v, sum_squares += v * v;
  }
  if (HISTORY_LIMIT == HISTORY_LIMIT_RANGE) return clamp(visibility, low, high);
  float mean = sum / kPixels;
  float spread = limit_deviations * sqrt(max(0.0, sum_squares / kPixels - mean * mean));
  return clamp(visibility, mean - spread, mean + spread);
}

void main() {
  ivec2 px = ivec2(gl_FragCoord.xy);
  vec4 position = texelFetch(gbuffer_position, px, 0);
  out_visibility = 1.0;
  out_mean = vec2(1.0, 0.0);
  if (position.w == 0.0) return;
  float now = texelFetch(current, px, 0).r;
  History before = history_of(position.xyz, texelFetch(gbuffer_normal, px, 0).xyz);
  float frames = min(before.frames + 1.0, float(history_frames));
  float earlier = before.frames > 0.0 ? limited(before.visibility) : now;
  out_visibility = mix(earlier, now, 1.0 / frames);
  out_mean = vec2(out_visibility, frames);
}
