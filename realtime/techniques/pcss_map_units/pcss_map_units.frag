// SPDX-License-Identifier: Apache-2.0
// Percentage-closer soft shadows as engines write them: a disk search, a penumbra from depths, a disk filter, all in units of
// the map and blind to the light's shape.
#include "disk_search.glsl"
#include "pixel.glsl"

/// A length in `radius_unit` in lateral coordinates.
float lateral_of_length(Receiver receiver, float size) {
  float to_lateral = is_orthographic(view_light) ? 1.0 : 1.0 / receiver.p_light.z;
  if (RADIUS_UNIT == RADIUS_UNIT_MAP) return size * texel_lateral(view_light) * view_light.depth_range.w;
  if (RADIUS_UNIT == RADIUS_UNIT_WORLD) return size * to_lateral;
  if (RADIUS_UNIT == RADIUS_UNIT_RANGE)
    return size * (view_light.depth_range.y - view_light.depth_range.x) * to_lateral;
  return size;
}

float disk_mean(Receiver receiver, float radius, float turn_rad) {
  float lit = 0.0;
  for (int i = 0; i < FILTER_TAPS; ++i) {
    vec2 lateral = receiver.lateral + radius * disk_tap(i, FILTER_TAPS, turn_rad);
    lit += lit_at(shadow_map, view_light, receiver, texel_position(view_light, lateral), BILINEAR_TAPS != 0);
  }
  return lit / float(FILTER_TAPS);
}

float visibility_of(Receiver receiver) {
  float known;
  if (is_known(view_light, receiver, known)) return known;
  float turn_rad = disk_turn_rad(noise_position());
  DiskSearch found = search_disk(receiver, lateral_of_length(receiver, search_radius), turn_rad);
  if (found.share == 0.0) return 1.0;
  float radius = min(penumbra_size * drop_value(receiver, found, DROP), most_radius);
  float lit = disk_mean(receiver, lateral_of_length(receiver, radius), turn_rad);
  return fade_share > 0.0 ? mix(1.0, lit, smoothstep(0.0, fade_share, found.share)) : lit;
}

void main() {
  Receiver receiver;
  out_visibility = fetch_receiver(receiver) ? visibility_of(receiver) : 1.0;
}
