// SPDX-License-Identifier: Apache-2.0
// The nearest depth in cells of 4 by 4 texels of the shadow map.
#include "nearest.glsl"

void main() { out_nearest_4 = nearest_of(shadow_map, ivec2(gl_FragCoord.xy), 4); }  // const: texels a side
