// SPDX-License-Identifier: Apache-2.0
// Every pixel.
#include "mask_visibility.glsl"

void main() {
  Receiver receiver;
  bool has_receiver = fetch_receiver(receiver);
  vec2 noise = kernel_noise(noise_position());
  out_visibility = has_receiver ? masked_visibility(receiver, gl_FragCoord.xy, noise) : 1.0;
}
