// SPDX-License-Identifier: Apache-2.0
// The nearest depth in cells of 8 by 8 texels of the shadow map.
#include "nearest.glsl"

void main() { out_nearest_8 = nearest_of(shadow_map, ivec2(gl_FragCoord.xy), 8); }  // const: texels a side
