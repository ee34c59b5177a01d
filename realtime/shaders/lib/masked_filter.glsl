// SPDX-License-Identifier: Apache-2.0
// The filters of techniques with an edge mask and the parameter filter_shape.
#include "box_pcf.glsl"
#include "disk_tables.glsl"
#include "pixel.glsl"

/// Mean of side x side comparisons a texel apart around the receiver.
float grid_lit(sampler2D map, LightViewData view, Receiver receiver, int side) {
  vec2 center = texel_position(view, receiver.lateral);
  float lit = 0.0;
  for (int i = 0; i < side * side; ++i) {
    vec2 from_middle = vec2(i % side, i / side) - 0.5 * float(side - 1);
    lit += lit_at(map, view, receiver, center + from_middle, false);
  }
  return lit / float(side * side);
}

/// Mean of side x side comparisons within side / 2 texels of the receiver.
float poisson_lit(sampler2D map, LightViewData view, Receiver receiver, int side) {
  vec2 center = texel_position(view, receiver.lateral);
  float angle_rad = kTwoPi * interleaved_gradient_noise(noise_position());
  mat2 turn = mat2(cos(angle_rad), sin(angle_rad), -sin(angle_rad), cos(angle_rad));
  float lit = 0.0;
  for (int i = 0; i < side * side; ++i) {
    lit += lit_at(map, view, receiver, center + 0.5 * float(side) * (turn * kPoissonDisk[i]), false);
  }
  return lit / float(side * side);
}

/// Of no width it is one comparison.
float masked_lit(sampler2D map, LightViewData view, Receiver receiver, float width_texels) {
  int side = int(round(width_texels));
  if (FILTER_SHAPE == FILTER_SHAPE_BOX || side < 1) return box_lit(map, view, receiver, width_texels);
  if (FILTER_SHAPE == FILTER_SHAPE_GRID) return grid_lit(map, view, receiver, side);
  return poisson_lit(map, view, receiver, side);
}
