// SPDX-License-Identifier: Apache-2.0
// The nearest depth in cells of 128 by 128 texels of the shadow map.
#include "nearest.glsl"

void main() { out_nearest_128 = nearest_of(nearest_32, ivec2(gl_FragCoord.xy), 4); }  // const: cells a side
