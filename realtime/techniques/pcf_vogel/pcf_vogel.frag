// Percentage-closer filtering over a Vogel disk of texels, turned from pixel to pixel.
#include "pixel.glsl"
#include "shadow_map.glsl"

float disk_mean(Receiver receiver, float rotation_rad) {
  vec2 center = texel_position(view_light, receiver.lateral);
  float lit = 0.0;
  for (int i = 0; i < TAPS; ++i) {
    vec2 p_texels = center + radius_texels * vogel_disk(i, TAPS, rotation_rad);
    lit += lit_at(shadow_map, view_light, receiver, p_texels, BILINEAR != 0);
  }
  return lit / float(TAPS);
}

float visibility_of(Receiver receiver) {
  float known;
  if (is_known(view_light, receiver, known)) return known;
  float turns = NOISE != 0 ? interleaved_gradient_noise(noise_position()) : 0.0;
  return disk_mean(receiver, kTwoPi * turns);
}

void main() {
  Receiver receiver;
  out_visibility = fetch_receiver(receiver) ? visibility_of(receiver) : 1.0;
}
