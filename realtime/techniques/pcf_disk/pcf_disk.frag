// SPDX-License-Identifier: Apache-2.0
// Percentage-closer filtering over a disk of texels: three patterns of taps, turned from pixel to pixel or not.
#include "disk_tables.glsl"
#include "pixel.glsl"
#include "shadow_map.glsl"
#include "white_noise.glsl"

vec2 tap_on_disk(int index, float rotation_rad) {
  if (PATTERN == PATTERN_VOGEL) return vogel_disk(index, TAPS, rotation_rad);
  vec2 tap = PATTERN == PATTERN_POISSON ? kPoissonDisk[index] : kBlueNoiseDisk[index];
  vec2 turn = vec2(cos(rotation_rad), sin(rotation_rad));
  return vec2(turn.x * tap.x - turn.y * tap.y, turn.y * tap.x + turn.x * tap.y);
}

float disk_mean(Receiver receiver, float rotation_rad) {
  vec2 center = texel_position(view_light, receiver.lateral);
  float lit = 0.0;
  for (int i = 0; i < TAPS; ++i) {
    vec2 p_texels = center + radius_texels * tap_on_disk(i, rotation_rad);
    lit += lit_at(shadow_map, view_light, receiver, p_texels, BILINEAR != 0);
  }
  return lit / float(TAPS);
}

/// By how much of a turn this pixel's disk is turned.
float turns_of_pixel() {
  if (ROTATION == ROTATION_GRADIENT_NOISE) return interleaved_gradient_noise(noise_position());
  if (ROTATION == ROTATION_NONE) return 0.0;
  vec2 p_px = pixel_position(gl_FragCoord.xy, float(frame.screen_and_seed.y));
  return white_noise(uvec3(p_px, frame.screen_and_seed.z)).x;
}

float visibility_of(Receiver receiver) {
  float known;
  return is_known(view_light, receiver, known) ? known : disk_mean(receiver, kTwoPi * turns_of_pixel());
}

void main() {
  Receiver receiver;
  out_visibility = fetch_receiver(receiver) ? visibility_of(receiver) : 1.0;
}
