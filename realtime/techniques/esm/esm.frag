// Exponential shadow maps (Annen et al. 2008; Salvi 2008): the step of a comparison as exp(c (z - z_receiver)), which
// is a product of what the map holds and what the receiver knows.
#include "esm_filter.glsl"
#include "pixel.glsl"

float visibility_of(Receiver receiver) {
  float known;
  if (is_known(view_light, receiver, known)) return known;
  float z = normalized_distance(view_light, receiver.p_light.z - receiver.bias_world);
  float filtered = bilinear_mean(warped, texel_position(view_light, receiver.lateral));
  if (FORM == FORM_EXPONENTIAL) return min(1.0, filtered * exp(exponent * (1.0 - z)));
  return min(1.0, exp(exponent * min(0.0, filtered - z)));
}

void main() {
  Receiver receiver;
  out_visibility = fetch_receiver(receiver) ? visibility_of(receiver) : 1.0;
}
