// SPDX-License-Identifier: Apache-2.0
// Mean and mean square of the distances in a texel, from a light view.
#include "texel_variance.glsl"

in float distance_world;

void main() {
  float z = normalized_distance(VIEW, distance_world);
  out_moments = vec2(z, z * z + fragment_variance(VIEW, distance_world, z));
}
