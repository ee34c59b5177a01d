// SPDX-License-Identifier: Apache-2.0
// Shadow-map ray tracing over cascades: rays have the sun's size in the world and stay in the map of the receiver's slice.
#include "cascades.glsl"

#include "map_rays.glsl"

float stored_depth(ivec2 texel) { return texelFetch(shadow_map, ivec3(texel, map_layer), 0).r; }

float visibility_of(Receiver receiver) { return share_of_rays(receiver); }
