// SPDX-License-Identifier: Apache-2.0
// Taps over the light's shape, for techniques with the parameters of the group light_filter.
#include "kernel_light.glsl"

/// Turns or shifts a kernel from pixel to pixel.
vec2 kernel_noise(vec2 p_px) {
  if (NOISE == 0) return vec2(0.0);
  return vec2(interleaved_gradient_noise(p_px), interleaved_gradient_noise(p_px.yx));
}

/// A grid has a whole number of taps a side.
int grid_side(int count) { return int(sqrt(float(count) + 0.5)); }

int tap_count(int count) { return KERNEL == KERNEL_GRID ? grid_side(count) * grid_side(count) : count; }

/// Tap `index` of `tap_count(count)`: on the light, or on a grid over the square around it.
vec2 kernel_tap(AreaLight light, int index, int count, vec2 noise) {
  if (KERNEL == KERNEL_LIGHT) return kernel_point(light, index, count, noise);
  int side = grid_side(count);
  return (2.0 * vec2(index % side, index / side) + 1.0) / float(side) - 1.0;
}
