// SPDX-License-Identifier: Apache-2.0
// Noise without any pattern, from integers.

/// Two values in [0,1) that belong to `key`: the first two of the hash pcg3d (Jarzynski and Olano 2020).
vec2 white_noise(uvec3 key) {
  uvec3 v = key * 1664525u + 1013904223u;  // const: the published generator
  for (int round = 0; round < 2; ++round) {
    v.x += v.y * v.z;
    v.y += v.z * v.x;
    v.z += v.x * v.y;
    if (round == 0) v ^= v >> 16u;  // const: half of the bits
  }
  return vec2(v.xy >> 8u) * exp2(-24.0);  // const: 24 bits fit a float
}
