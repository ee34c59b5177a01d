// Percentage-closer filtering as wide as the highest band nearby says, one comparison without any (Evans, Agenjo and
// Blat 2014).
#include "box_pcf.glsl"
#include "dilated_mask.glsl"
#include "pixel.glsl"

float width_around(Receiver receiver) {
  vec4 widths = vec4(0.0, width_1_texels, width_2_texels, width_3_texels);
  vec2 p_blocks = texel_position(view_light, receiver.lateral) * shadow_map_size.zw * mask_size.xy;
  return widths[int(round(3.0 * highest_around(mask, p_blocks)))];  // const: bands
}

float visibility_of(Receiver receiver) {
  float known;
  if (is_known(view_light, receiver, known)) return known;
  return box_lit(shadow_map, view_light, receiver, width_around(receiver));
}

void main() {
  Receiver receiver;
  out_visibility = fetch_receiver(receiver) ? visibility_of(receiver) : 1.0;
}
