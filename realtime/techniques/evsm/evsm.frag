// SPDX-License-Identifier: Apache-2.0
// Exponential variance shadow maps over a map that was blurred once.
#include "exponential_bound.glsl"
#include "pixel.glsl"

float visibility_of(Receiver receiver) {
  float known;
  if (is_known(view_light, receiver, known)) return known;
  vec2 p_texels = texel_position(view_light, receiver.lateral);
  if (any(lessThan(p_texels, vec2(0.0))) || any(greaterThan(p_texels, moments_size.xy))) return 1.0;
  return exponential_visibility(view_light, receiver, texture(moments, p_texels * moments_size.zw));
}

void main() {
  Receiver receiver;
  out_visibility = fetch_receiver(receiver) ? visibility_of(receiver) : 1.0;
}
