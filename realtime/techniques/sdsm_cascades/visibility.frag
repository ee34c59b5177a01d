// SPDX-License-Identifier: Apache-2.0
// One comparison in the map of the pixel's slice, or the mean of some on a disk.
#include "stored_views.glsl"

#define CASCADES CASCADE_COUNT
#include "cascade_choice.glsl"

float lit_at_tap(Receiver receiver, vec2 lateral) {
  vec2 lateral_met;
  float z_met;
  return find_blocker_at(shadow_map, view_light, receiver, lateral, lateral_met, z_met) ? 0.0 : 1.0;
}

float disk_lit(Receiver receiver) {
  float rotation_rad = kTwoPi * interleaved_gradient_noise(noise_position());
  // Texels are as wide as the map needs on either axis: the disk is round in texels.
  vec2 texel = (view_light.lateral_bounds.zw - view_light.lateral_bounds.xy) / view_light.depth_range.w;
  float lit = 0.0;
  for (int i = 0; i < TAPS; ++i)
    lit += lit_at_tap(receiver, receiver.lateral + radius_texels * texel * vogel_disk(i, TAPS, rotation_rad));
  return lit / float(TAPS);
}

float visibility_of(Receiver receiver) {
  float known;
  if (is_known(view_light, receiver, known)) return known;
  return MAP_FILTER == MAP_FILTER_PCF ? disk_lit(receiver) : lit_at_tap(receiver, receiver.lateral);
}
