// Percentage-closer filtering where the mask is on, one comparison elsewhere (Evans, Agenjo and Blat 2014).
#include "box_pcf.glsl"
#include "dilated_mask.glsl"
#include "pixel.glsl"

bool is_near_edge(Receiver receiver) {
  vec2 p_blocks = texel_position(view_light, receiver.lateral) * shadow_map_size.zw * mask_size.xy;
  return highest_around(mask, p_blocks) > 0.0;
}

float visibility_of(Receiver receiver) {
  float known;
  if (is_known(view_light, receiver, known)) return known;
  return box_lit(shadow_map, view_light, receiver, is_near_edge(receiver) ? filter_width_texels : 0.0);
}

void main() {
  Receiver receiver;
  out_visibility = fetch_receiver(receiver) ? visibility_of(receiver) : 1.0;
}
