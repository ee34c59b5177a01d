// SPDX-License-Identifier: Apache-2.0
// One axis of the seven-tap Gaussian.
#include "mask_value.glsl"

/// Texels between two taps: one, or what keeps the kernel's radius (three taps) the same length in the world.
float tap_distance_texels() {
  if (BLUR != BLUR_DISTANCE_SCALED) return 1.0;
  vec4 position = texelFetch(gbuffer_position, pixel_of_texel(ivec2(gl_FragCoord.xy)), 0);
  if (position.w == 0.0) return 1.0;
  mat4 clip = frame.clip_from_world;
  float distance_world = (clip * vec4(position.xyz, 1.0)).w;
  float focal = length(vec3(clip[0][1], clip[1][1], clip[2][1]));  // 1 / tan of half the vertical field of view
  float px_per_world = 0.5 * float(frame.screen_and_seed.y) * focal / distance_world;
  return blur_radius_world * px_per_world / float(3 * MASK_DIVISOR);  // const: three taps to each side
}

vec2 blurred(sampler2D map, vec2 texel_size, vec2 axis) {
  const float kSigmaTaps = 3.0;  // const: published
  vec2 step_uv = tap_distance_texels() * axis * texel_size;
  vec2 sum = vec2(0.0);
  float total = 0.0;
  for (int i = -3; i <= 3; ++i) {  // const: 7 taps
    float weight = exp(-0.5 * float(i * i) / (kSigmaTaps * kSigmaTaps));
    sum += weight * texture(map, gl_FragCoord.xy * texel_size + float(i) * step_uv).rg;
    total += weight;
  }
  return stored(sum / total);
}
