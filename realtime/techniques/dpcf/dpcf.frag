// SPDX-License-Identifier: Apache-2.0
// Percentage-closer filtering whose answer is hardened where blockers are near: one set of taps for search and filter
// (Filament's DPCF, after Myers).
#include "disk_search.glsl"
#include "kernel_light.glsl"
#include "pixel.glsl"

/// Radius of the disk in lateral coordinates.
float kernel_lateral(Receiver receiver) {
  bool is_sun = is_orthographic(view_light);
  float z_receiver = receiver.p_light.z;
  if (RADIUS_BASE == RADIUS_BASE_WORLD) return is_sun ? radius_world : radius_world / z_receiver;
  vec2 half_extent = kernel_light().half_extent;
  float radius = sqrt(half_extent.x * half_extent.y);
  return is_sun ? radius * max(0.0, z_receiver - view_light.depth_range.x) : radius / z_receiver;
}

/// A steeper share, the same at 0, a half and 1.
float hardened(float share) {
  float side = sign(2.0 * share - 1.0);
  float rest = 1.0 - abs(2.0 * share - 1.0);
  return 0.5 + 0.5 * side * (1.0 - rest * rest * rest);
}

float visibility_of(Receiver receiver) {
  float known;
  if (is_known(view_light, receiver, known)) return known;
  DiskSearch found = search_disk(receiver, kernel_lateral(receiver), disk_turn_rad(noise_position()));
  if (found.share == 0.0) return 1.0;
  float softness = clamp(ratio_scale * drop_value(receiver, found, RATIO), 0.0, 1.0);
  return 1.0 - mix(hardened(found.share), found.share, softness);
}

void main() {
  Receiver receiver;
  out_visibility = fetch_receiver(receiver) ? visibility_of(receiver) : 1.0;
}
