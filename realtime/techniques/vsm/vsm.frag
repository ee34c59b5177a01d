// Variance shadow maps (Donnelly and Lauritzen 2006) over a map that was blurred once.
#include "filtered_plane.glsl"
#include "pixel.glsl"
#include "variance_bound.glsl"

float visibility_of(Receiver receiver) {
  float known;
  if (is_known(view_light, receiver, known)) return known;
  receiver.bias_world += plane_bias_world(view_light, receiver, filter_width_texels);
  vec2 uv = texel_position(view_light, receiver.lateral) * moments_size.zw;
  return variance_visibility(view_light, receiver, texture(moments, uv).rg);
}

void main() {
  Receiver receiver;
  out_visibility = fetch_receiver(receiver) ? visibility_of(receiver) : 1.0;
}
