// SPDX-License-Identifier: Apache-2.0
// The pixels of a pattern, packed (Sterna 2018, 3).
#include "checkerboard.glsl"
#include "mask_visibility.glsl"

void main() {
  int height = frame.screen_and_seed.y;
  ivec2 px = min(pixel_of(ivec2(gl_FragCoord.xy)), frame.screen_and_seed.xy - 1);  // the last one of odd sizes
  vec2 p_px = (vec2(px) + 0.5) * vec2(1.0, noise_stretch);
  ivec2 frag_px = flipped(px, height);
  Receiver receiver;
  bool has_receiver = fetch_receiver_at(frag_px, receiver);
  vec2 noise = kernel_noise(seeded_position(p_px, frame.screen_and_seed.z));
  out_packed_visibility = has_receiver ? masked_visibility(receiver, vec2(frag_px) + 0.5, noise) : 1.0;
}
