// SPDX-License-Identifier: Apache-2.0
// 16 x 16 points of the light's square [-1,1]^2, a bit each: set where a receiver does not see them.
#include "kernel_light.glsl"

const int kMaskSide = 16;     // const: points a side
const uint kRowBits = 16u;    // const: two rows a word

struct LightMask {
  uint words[8];  // const: 16 rows, two a word
};

/// Coordinate of point `index` on an axis.
float mask_coordinate(int index) { return (2.0 * float(index) + 1.0) / float(kMaskSide) - 1.0; }

/// The first point at or after `coordinate`.
int first_point(float coordinate) {
  return clamp(int(ceil(0.5 * (coordinate + 1.0) * float(kMaskSide) - 0.5)), 0, kMaskSide);
}

uint bits_between(int first, int end) { return ((1u << uint(end - first)) - 1u) << uint(first); }

uint row_of(LightMask mask, int row) { return mask.words[row >> 1] >> (kRowBits * uint(row & 1)) & 0xffffu; }

void cover(inout LightMask mask, vec2 low, vec2 high) {
  int x_first = first_point(low.x);
  int x_end = first_point(high.x);
  int y_end = first_point(high.y);
  if (x_end <= x_first) return;
  uint bits = bits_between(x_first, x_end);
  for (int y = first_point(low.y); y < y_end; ++y) mask.words[y >> 1] |= bits << (kRowBits * uint(y & 1));
}

/// The points of a row that lie on the light.
uint light_row(AreaLight light, int row) {
  if (light.type == kRect) return 0xffffu;
  float y = mask_coordinate(row);
  float half_width = sqrt(max(0.0, 1.0 - y * y));
  int first = first_point(-half_width);
  return bits_between(first, kMaskSide - first);
}

/// The points of a row that lie above the receiver's horizon.
uint facing_row(AreaLight light, Receiver receiver, int row) {
  uint bits = 0u;
  for (int x = 0; x < kMaskSide; ++x) {
    vec2 kernel = vec2(mask_coordinate(x), mask_coordinate(row));
    if (faces(receiver, ray_to_light(light, receiver, kernel))) bits |= 1u << uint(x);
  }
  return bits;
}

bool is_above_horizon(AreaLight light, Receiver receiver) {
  for (int i = 0; i < 4; ++i) {  // const: corners of the square
    if (!faces(receiver, ray_to_light(light, receiver, 2.0 * vec2(i & 1, i >> 1) - 1.0))) return false;
  }
  return true;
}

/// Share of the light's points that are neither covered nor below the horizon.
float open_share(AreaLight light, Receiver receiver, LightMask mask) {
  bool is_above = is_above_horizon(light, receiver);
  int open = 0;
  int total = 0;
  for (int row = 0; row < kMaskSide; ++row) {
    uint on_light = light_row(light, row);
    uint facing = is_above ? 0xffffu : facing_row(light, receiver, row);
    open += bitCount(on_light & facing & ~row_of(mask, row));
    total += bitCount(on_light);
  }
  return float(open) / float(total);
}
