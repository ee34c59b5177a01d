// SPDX-License-Identifier: Apache-2.0
// Variance soft shadow maps (Yang et al. 2010): Chebyshev's bound over the box that rays to the light can meet says how far
// blockers are, over the box that they meet at that distance how much light passes.
#include "kernel_light.glsl"
#include "pixel.glsl"
#include "search_bound.glsl"
#include "sum_table.glsl"
#include "variance_bound.glsl"

struct Box {
  vec2 low, high;
};

/// Whether the rays from the receiver to the light get to distance `z`, and the box of texels they meet there: as wide as the
/// light, for round ones of the same area.
bool find_footprint(AreaLight light, Receiver receiver, float z, out Box box) {
  float side = light.type == kRect ? 1.0 : 0.5 * sqrt(0.5 * kTwoPi);
  box = Box(vec2(1e9), vec2(-1e9));  // const: beyond any map
  for (int i = 0; i < 4; ++i) {      // const: corners of a square
    vec3 ray = ray_to_light(light, receiver, side * (2.0 * vec2(i & 1, i >> 1) - 1.0));
    if (ray.z >= 0.0) return false;
    vec2 p_texels = texel_position(view_light, lateral_on_ray(view_light, receiver, ray, z));
    box = Box(min(box.low, p_texels), max(box.high, p_texels));
  }
  vec2 middle = 0.5 * (box.low + box.high);
  vec2 extent = clamp(box.high - box.low, vec2(1.0), vec2(float(CELLS * MOST_WIDTH_TEXELS)));
  box = Box(middle - 0.5 * extent, middle + 0.5 * extent);
  return true;
}

/// Moments over a cell of a box, as if the receiver's tangent plane were at the receiver's distance everywhere: a slope neither
/// darkens nor widens the variance. `drop` is by how much the cell was moved for that.
vec2 cell_moments(Receiver receiver, Box box, int index, out float drop) {
  vec2 cell = (box.high - box.low) / float(CELLS);
  vec2 low = box.low + cell * vec2(index % CELLS, index / CELLS);
  float z_plane = surface_distance_at(view_light, receiver, lateral_of_texel(view_light, low + 0.5 * cell));
  drop = normalized_length(view_light, receiver.p_light.z - z_plane, receiver.p_light.z);
  return shifted_moments(mean_over(low, low + cell), drop);
}

/// Share of a cell that is no nearer than `z`, at most. Rounded sums have a variance of their own.
float open_share(vec2 moments, float z, float z_world) {
  return chebyshev(moments, z, max(least_variance(view_light, z_world), 1.0 / kSumScale));
}

/// Mean normalised distance of what blocks; `z` for nothing. What does not is taken to lie on the receiver's plane.
float mean_blocker(Receiver receiver, Box box, float z) {
  const float kNone = 1e-4;  // const: share of blockers that is rounding
  vec2 sum = vec2(0.0);      // their share, and their distances
  for (int i = 0; i < CELLS * CELLS; ++i) {
    float drop;
    vec2 moments = cell_moments(receiver, box, i, drop);
    float open = open_share(moments, z, receiver.p_light.z);
    sum += vec2(1.0 - open, moments.x - open * z - (1.0 - open) * drop);
  }
  return sum.x > kNone * float(CELLS * CELLS) ? clamp(sum.y / sum.x, 0.0, z) : z;
}

float passed_share(Receiver receiver, Box box, float z) {
  float passed = 0.0;
  for (int i = 0; i < CELLS * CELLS; ++i) {
    float drop;
    passed += open_share(cell_moments(receiver, box, i, drop), z, receiver.p_light.z);
  }
  return without_bleeding(passed / float(CELLS * CELLS), bleed_reduction);
}

float visibility_of(Receiver receiver) {
  float known;
  if (is_known(view_light, receiver, known)) return known;
  AreaLight light = kernel_light();
  float z_search = nearest_blocker_bound(light, receiver);
  Box box;
  if (z_search >= receiver.p_light.z || !find_footprint(light, receiver, z_search, box)) return 1.0;
  float z = normalized_distance(view_light, receiver.p_light.z - receiver.bias_world);
  float blocker = mean_blocker(receiver, box, z);
  if (blocker >= z) return 1.0;
  if (!find_footprint(light, receiver, distance_of_normalized(view_light, blocker), box)) return 1.0;
  return passed_share(receiver, box, z);
}

void main() {
  Receiver receiver;
  out_visibility = fetch_receiver(receiver) ? visibility_of(receiver) : 1.0;
}
