// SPDX-License-Identifier: Apache-2.0
// The nearest depth in cells of 2 by 2 texels of the shadow map.
#include "nearest.glsl"

void main() { out_nearest_2 = nearest_of(shadow_map, ivec2(gl_FragCoord.xy), 2); }  // const: texels a side
