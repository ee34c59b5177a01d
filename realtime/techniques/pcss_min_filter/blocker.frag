// SPDX-License-Identifier: Apache-2.0
// Mean of 3 x 3 nearest distances: the lumps a minimum leaves, softened.
#include "spaces.glsl"

void main() {
  ivec2 cell = ivec2(gl_FragCoord.xy);
  ivec2 last = textureSize(nearest_4, 0) - 1;
  float sum = 0.0;
  for (int i = 0; i < 9; ++i) {  // const: 3 x 3 cells
    ivec2 tap = clamp(cell + ivec2(i % 3, i / 3) - 1, ivec2(0), last);  // const: the same
    sum += distance_of_depth(view_light, texelFetch(nearest_4, tap, 0).r);
  }
  out_blocker = sum / 9.0;  // const: the same
}
