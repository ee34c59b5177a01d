// SPDX-License-Identifier: Apache-2.0
// A box of real-valued width over texels.

/// Length of [low, high] inside the texel [index, index + 1]; all of the texel for a box of no width.
float box_weight(int index, float low, float high) {
  if (low == high) return 1.0;
  return max(0.0, min(high, float(index) + 1.0) - max(low, float(index)));
}

/// Last texel a box ending at `high` touches.
int last_texel(float low, float high) { return max(int(floor(low)), int(ceil(high)) - 1); }
