// SPDX-License-Identifier: Apache-2.0
// The exponential shadow map before its blur.
#include "esm_filter.glsl"

in float distance_world;

void main() { out_warped = stored_value(normalized_distance(VIEW, distance_world)); }
