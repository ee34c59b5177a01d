// SPDX-License-Identifier: Apache-2.0
// Coarser copies of a depth map that keep the nearest.

/// Nearest (greatest reversed) depth of `side` by `side` texels of `map`, those of the coarse texel `cell`.
float nearest_of(sampler2D map, ivec2 cell, int side) {
  ivec2 first = cell * side;
  ivec2 end = min(first + side, textureSize(map, 0));
  float nearest = 0.0;
  for (int y = first.y; y < end.y; ++y) {
    for (int x = first.x; x < end.x; ++x) nearest = max(nearest, texelFetch(map, ivec2(x, y), 0).r);
  }
  return nearest;
}
