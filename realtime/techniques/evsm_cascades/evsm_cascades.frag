// SPDX-License-Identifier: Apache-2.0
// Exponential variance shadow maps over cascades: a blurred map for each slice, on a range of distances of its own.
#include "cascades.glsl"

#include "exponential_bound.glsl"

float visibility_of(Receiver receiver) {
  float known;
  if (is_known(view_light, receiver, known)) return known;
  vec2 p_texels = texel_position(view_light, receiver.lateral);
  if (any(lessThan(p_texels, vec2(0.0))) || any(greaterThan(p_texels, moments_size.xy))) return 1.0;
  vec4 filtered = texture(moments, vec3(p_texels * moments_size.zw, float(map_layer)));
  return exponential_visibility(view_light, receiver, filtered);
}
