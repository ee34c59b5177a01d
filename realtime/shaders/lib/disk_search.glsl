// SPDX-License-Identifier: Apache-2.0
// A search for blockers over a disk of the map that follows no light's shape, for techniques with the parameters of the group
// disk_search.
#include "blocker_truth.glsl"
#include "sampling.glsl"
#include "shadow_map.glsl"
#include "white_noise.glsl"

/// What the search met: the share of taps with a blocker, and the blockers' means.
struct DiskSearch {
  float share;
  float mean_distance;
  float mean_stored;  // of stored depth, 0 at the near plane and 1 at the far one, as depth buffers commonly are
};

float stored_depth(LightViewData view, float distance_world) { return 1.0 - depth_of_distance(view, distance_world); }

/// Angle by which the disk of the pixel at `p_px` is turned.
float disk_turn_rad(vec2 p_px) {
  if (ROTATION == ROTATION_NONE) return 0.0;
  if (ROTATION == ROTATION_GRADIENT_NOISE) return kTwoPi * interleaved_gradient_noise(p_px);
  return kTwoPi * white_noise(uvec3(p_px, frame.screen_and_seed.z)).x;
}

/// Tap `index` of `count` on the unit disk; the share u of them lies within u^focus.
vec2 disk_tap(int index, int count, float turn_rad) {
  vec2 even = vogel_disk(index, count, turn_rad);
  return even * pow(length(even), 2.0 * focus - 1.0);
}

/// Over a disk of `radius` in lateral coordinates.
DiskSearch search_disk(Receiver receiver, float radius, float turn_rad) {
  DiskSearch found = DiskSearch(0.0, 0.0, 0.0);
  for (int i = 0; i < SEARCH_TAPS; ++i) {
    vec2 lateral_met;
    float z_met;
    vec2 lateral = receiver.lateral + radius * disk_tap(i, SEARCH_TAPS, turn_rad);
    if (!find_blocker_at(shadow_map, view_light, receiver, lateral, lateral_met, z_met)) continue;
    found.share += 1.0;
    found.mean_distance += z_met;
    found.mean_stored += stored_depth(view_light, z_met);
  }
  if (found.share > 0.0) {
    found.mean_distance /= found.share;
    found.mean_stored /= found.share;
  }
  found.share /= float(SEARCH_TAPS);
#ifdef BLOCKER_FROM_TRUTH
  found.mean_distance = true_blocker_distance(view_light, receiver);
  found.mean_stored = stored_depth(view_light, found.mean_distance);
#endif
  return found;
}

/// What penumbrae grow with: (z_r - z_b) / z_b of distances, the same of stored depths, the drop in ranges of stored depth, or
/// the drop in world units.
float drop_value(Receiver receiver, DiskSearch found, int measure) {
  const int kRatio = 0;        // const: choice of the techniques' parameter
  const int kStoredRatio = 1;  // const: the same
  const int kStoredDrop = 2;   // const: the same
  float z_receiver = receiver.p_light.z;
  float stored_drop = stored_depth(view_light, z_receiver) - found.mean_stored;
  if (measure == kRatio) return max(0.0, z_receiver - found.mean_distance) / found.mean_distance;
  if (measure == kStoredRatio) return max(0.0, stored_drop) / max(found.mean_stored, 1e-6);  // const: at the near plane
  return max(0.0, measure == kStoredDrop ? stored_drop : z_receiver - found.mean_distance);
}
