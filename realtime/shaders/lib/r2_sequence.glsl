// SPDX-License-Identifier: Apache-2.0
// A sequence of points whose every run is spread evenly, for taps that go on from frame to frame.
#include "sampling.glsl"
#ifdef OFFSET_NOISE
#if OFFSET_NOISE == OFFSET_NOISE_BLUE
#include "blue_noise.glsl"
#endif
#endif

/// Point `index` of the sequence R2 (Roberts 2018: multiples of 1/g and 1/g^2, g = 1.32471795724474602596) moved by
/// `offset` and wrapped (Cranley and Patterson 1976): in [0,1)^2. In whole numbers, so that late points are as exact as early ones.
vec2 r2_point(int index, vec2 offset) {
  uvec2 steps = uvec2(3242174889u, 2447445414u) * uint(index);  // const: 2^32 / g, 2^32 / g^2
  return fract(offset + vec2(steps >> 8u) * exp2(-24.0));       // const: 24 bits fit a float
}

/// How far this pixel's sequence is moved: interleaved gradient noise along both axes, or as the parameter offset_noise says.
/// From frame to frame the sequence itself goes on: a turn by the golden ratio's kin in two dimensions.
vec2 r2_offset(vec2 p_px) {
#ifdef OFFSET_NOISE
#if OFFSET_NOISE == OFFSET_NOISE_BLUE
  return blue_noise(p_px);
#endif
#endif
  return vec2(interleaved_gradient_noise(p_px), interleaved_gradient_noise(p_px.yx));
}
