// SPDX-License-Identifier: Apache-2.0
// How far from the receiver blockers can be, from coarse maps of the nearest depth in their cells: a caster near the
// light widens the search only where it stands. For techniques with the parameter search_shrink.
#include "penumbra.glsl"
#include "shadow_map.glsl"

/// The texels that rays from the receiver to the light can meet at distance `z`; false when some do not get there.
bool find_search_box(AreaLight light, Receiver receiver, float z, out vec2 low_texels, out vec2 high_texels) {
  low_texels = vec2(view_light.depth_range.w);
  high_texels = vec2(0.0);
  for (int i = 0; i < 4; ++i) {  // const: the corners of the square around the kernel
    vec3 ray = ray_to_light(light, receiver, 2.0 * vec2(i & 1, i >> 1) - 1.0);
    if (ray.z >= 0.0) return false;
    vec2 p_texels = texel_position(view_light, lateral_on_ray(view_light, receiver, ray, z));
    low_texels = min(low_texels, p_texels - 1.0);  // a blocker's centre lies up to a texel beside its ray
    high_texels = max(high_texels, p_texels + 1.0);
  }
  return true;
}

#ifdef nearest_8_size

/// Nearest (greatest reversed) depth in the cells of `map` that touch a box of texels.
float nearest_in_cells(sampler2D map, float cell_texels, vec2 low_texels, vec2 high_texels) {
  ivec2 last_cell = textureSize(map, 0) - 1;
  ivec2 low = clamp(ivec2(floor(low_texels / cell_texels)), ivec2(0), last_cell);
  ivec2 high = clamp(ivec2(floor(high_texels / cell_texels)), ivec2(0), last_cell);
  float nearest = 0.0;
  for (int y = low.y; y <= high.y; ++y) {
    for (int x = low.x; x <= high.x; ++x) nearest = max(nearest, texelFetch(map, ivec2(x, y), 0).r);
  }
  return nearest;
}

/// From the finest map in which at most five by five cells touch the box.
float nearest_in_box(vec2 low_texels, vec2 high_texels) {
  vec2 extent = high_texels - low_texels;
  float cells_of_8 = max(extent.x, extent.y) / 32.0;  // const: four cells of 8 texels
  if (cells_of_8 <= 1.0) return nearest_in_cells(nearest_8, 8.0, low_texels, high_texels);  // const: texels a cell
  if (cells_of_8 <= 4.0) return nearest_in_cells(nearest_32, 32.0, low_texels, high_texels);  // const: the same
  if (cells_of_8 <= 16.0) return nearest_in_cells(nearest_128, 128.0, low_texels, high_texels);  // const: the same
  return nearest_in_cells(nearest_512, 512.0, low_texels, high_texels);  // const: the same
}

/// No blocker is nearer to the light than this. Every blocker lies inside the box at a distance that none is nearer than,
/// so the nearest one in that box is such a distance too, and its box is smaller.
float nearest_blocker_bound(AreaLight light, Receiver receiver) {
  float z_search = view_light.depth_range.x;
#ifdef PENUMBRA_CURVE
  if (kHasCurve) return z_search;  // its search does not follow the rays
#endif
  vec2 low_texels;
  vec2 high_texels;
  for (int i = 0; i < SEARCH_SHRINK && z_search < receiver.p_light.z; ++i) {
    if (!find_search_box(light, receiver, z_search, low_texels, high_texels)) break;
    float depth_reversed = nearest_in_box(low_texels, high_texels);
    if (depth_reversed <= 0.0) return receiver.p_light.z;
    z_search = max(z_search, distance_of_depth(view_light, depth_reversed));
  }
  return z_search;
}

#else

float nearest_blocker_bound(AreaLight light, Receiver receiver) { return view_light.depth_range.x; }

#endif
