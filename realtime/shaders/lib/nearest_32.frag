// SPDX-License-Identifier: Apache-2.0
// The nearest depth in cells of 32 by 32 texels of the shadow map.
#include "nearest.glsl"

void main() { out_nearest_32 = nearest_of(nearest_8, ivec2(gl_FragCoord.xy), 4); }  // const: cells a side
