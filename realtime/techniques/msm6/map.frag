// SPDX-License-Identifier: Apache-2.0
// The normalised distance; its moments afterwards, because what clears the map must not depend on their form.
#include "moments.glsl"

in float distance_world;

void main() { out_surface = normalized_distance(VIEW, distance_world); }
