// SPDX-License-Identifier: Apache-2.0
// Taps over the light's shape, for techniques with the parameters of the group light_filter.
#include "kernel_light.glsl"
#include "r2_sequence.glsl"
#include "white_noise.glsl"

/// Turns or shifts a kernel from pixel to pixel; jittered: the number of the pixel in its tile, which names its set.
vec2 kernel_noise(vec2 p_px) {
  if (NOISE == 0) return vec2(0.0);
  if (KERNEL == KERNEL_JITTERED) {
    vec2 in_tile = mod(floor(p_px), 16.0);              // const: pixels a side, as published
    return vec2(16.0 * in_tile.y + in_tile.x, 0.0);     // const: the same
  }
  return vec2(interleaved_gradient_noise(p_px), interleaved_gradient_noise(p_px.yx));
}

/// A grid has a whole number of taps a side.
int grid_side(int count) { return int(sqrt(float(count) + 0.5)); }

int tap_count(int count) { return KERNEL == KERNEL_LIGHT ? count : grid_side(count) * grid_side(count); }

/// Taps after which a kernel may stop, its outermost ring; -1 for never.
int early_tap_count(int count) { return EARLY_OUT != 0 ? grid_side(count) : -1; }

/// Tap `index` of set `set`: a cell of the jittered grid, its rows wrapped around the disk as rings of equal area
/// (Uralsky 2005), the outermost first, then from the middle outwards.
vec2 jittered_tap(int index, int side, uint set) {
  int row = index / side;
  vec2 corner = vec2(index % side, row == 0 ? side - 1 : row - 1);
  vec2 cell = (corner + white_noise(uvec3(index, set, side))) / float(side);
  float angle_rad = kTwoPi * cell.x;
  return sqrt(cell.y) * vec2(cos(angle_rad), sin(angle_rad));
}

/// Tap `index` of `tap_count(count)`: on the light, on the disk of a curve, or on a grid over the square around it. With
/// TAPS_OVER_FRAMES those on the light go on from frame to frame.
vec2 kernel_tap(AreaLight light, int index, int count, vec2 noise) {
#ifdef TAPS_OVER_FRAMES
  if (KERNEL == KERNEL_LIGHT) {
    vec2 uv = r2_point(history.frame.x * count + index, noise);
    return light.type == kRect ? 2.0 * uv - 1.0 : concentric_disk(uv);
  }
#endif
#ifdef PENUMBRA_CURVE
  if (KERNEL == KERNEL_LIGHT && PENUMBRA_CURVE != PENUMBRA_CURVE_PHYSICAL)
    return vogel_disk(index, count, kTwoPi * noise.x);
#endif
  if (KERNEL == KERNEL_LIGHT) return kernel_point(light, index, count, noise);
  int side = grid_side(count);
  if (KERNEL == KERNEL_JITTERED) return jittered_tap(index, side, uint(noise.x));
  return (2.0 * vec2(index % side, index / side) + 1.0) / float(side) - 1.0;
}
