// SPDX-License-Identifier: Apache-2.0
// Percentage-closer filtering as wide as the highest band nearby says, one comparison without any (Evans, Agenjo and
// Blat 2014).
#include "dilated_mask.glsl"
#include "masked_filter.glsl"

int level_for(float width_texels) { return int(ceil(log2(max(1.0, width_texels)))); }

/// The filter of the highest band within that filter's own reach.
float width_around(Receiver receiver) {
  vec3 widths = vec3(width_1_texels, width_2_texels, width_3_texels);
  int widest_level = level_for(max(widths.x, max(widths.y, widths.z)));
  int last = textureQueryLevels(mask) - 1;
  vec2 p_texels = texel_position(view_light, receiver.lateral);
  for (int i = 2; i >= 0; --i) {  // const: bands
    int level = max(0, last - widest_level + level_for(widths[i]));
    if (round(3.0 * highest_around(mask, level, p_texels)) > float(i)) return widths[i];  // const: bands
  }
  return 0.0;
}

float visibility_of(Receiver receiver) {
  float known;
  if (is_known(view_light, receiver, known)) return known;
  return masked_lit(shadow_map, view_light, receiver, width_around(receiver));
}

void main() {
  Receiver receiver;
  out_visibility = fetch_receiver(receiver) ? visibility_of(receiver) : 1.0;
}
