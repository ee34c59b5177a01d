// SPDX-License-Identifier: Apache-2.0
// Where the shadow map has a step, before the mask is dilated.
#include "edge_filter.glsl"

void main() {
  ivec2 texel = ivec2(gl_FragCoord.xy);
  float least = threshold;
  if (THRESHOLD_UNIT == THRESHOLD_UNIT_TEXELS) {
    least *= texel_world(view_light, edge_value(shadow_map, view_light, texel, false));
  }
  float height = step_height(shadow_map, view_light, texel, THRESHOLD_UNIT == THRESHOLD_UNIT_STORED_DEPTH);
  out_mask = edge_strength(height) >= least ? 1.0 : 0.0;
}
