// SPDX-License-Identifier: Apache-2.0
// The nearest depth in cells of 512 by 512 texels of the shadow map.
#include "nearest.glsl"

void main() { out_nearest_512 = nearest_of(nearest_128, ivec2(gl_FragCoord.xy), 4); }  // const: cells a side
