// SPDX-License-Identifier: Apache-2.0
// Distance and its variance inside the texel; warped afterwards, because what clears the map must not depend on
// the exponents.
#include "texel_variance.glsl"

in float distance_world;

void main() {
  float z = normalized_distance(VIEW, distance_world);
  out_surface = vec2(z, fragment_variance(VIEW, distance_world, z));
}
