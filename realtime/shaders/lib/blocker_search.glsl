// SPDX-License-Identifier: Apache-2.0
// The mean distance of what blocks a receiver's view of the light (Fernando 2005), for techniques with the parameters
// of the group blocker_search. Reads the resource shadow_map, or its halved copy nearest_2 where there is one.
#include "light_kernel.glsl"
#include "penumbra.glsl"
#include "shadow_map.glsl"

#ifdef nearest_2_size

/// As find_blocker, for two by two texels of which the map keeps the nearest: the tangent plane is compared at all
/// four centres.
bool find_search_blocker(Receiver receiver, vec2 lateral, out vec2 lateral_blocker, out float z_blocker) {
  ivec2 block = texel_at(view_light, lateral) >> 1;
  vec2 middle_texels = 2.0 * vec2(block) + 1.0;
  lateral_blocker = lateral_of_texel(view_light, middle_texels);
  float depth_reversed = is_in_map(view_light, 2 * block) ? texelFetch(nearest_2, block, 0).r : 0.0;
  if (depth_reversed <= 0.0) return false;
  z_blocker = distance_of_depth(view_light, depth_reversed);
  for (int i = 0; i < 4; ++i) {  // const: the texels of the block
    vec2 centre_texels = middle_texels + vec2(i & 1, i >> 1) - 0.5;
    float z_lit = compare_distance(view_light, receiver, lateral_of_texel(view_light, centre_texels));
    if (z_blocker >= z_lit) return false;
  }
  return true;
}

float search_texel_lateral() { return 2.0 * texel_lateral(view_light); }

#else

bool find_search_blocker(Receiver receiver, vec2 lateral, out vec2 lateral_blocker, out float z_blocker) {
  return find_blocker_at(shadow_map, view_light, receiver, lateral, lateral_blocker, z_blocker);
}

float search_texel_lateral() { return texel_lateral(view_light); }

#endif

/// Blockers between `z_search` and the receiver. Their mean distance, or the receiver's own for none.
float mean_blocker_distance(AreaLight light, Receiver receiver, vec2 noise, float z_search) {
  if (is_behind(view_light, receiver) || z_search >= receiver.p_light.z) return receiver.p_light.z;
  bool is_harmonic = false;
#ifdef AVERAGE
  is_harmonic = AVERAGE == AVERAGE_HARMONIC && !is_orthographic(view_light);
#endif
  float slack = search_texel_lateral();
  float sum = 0.0;
  float count = 0.0;
  float met = 0.0;  // blockers inside the cone of rays or not: the ring of a wide search lies outside
  for (int i = 0; i < tap_count(SEARCH_TAPS); ++i) {
    if (i == early_tap_count(SEARCH_TAPS) && (met == 0.0 || count == float(i))) break;
    vec2 kernel = focused(light, kernel_tap(light, i, SEARCH_TAPS, noise), search_focus);
    vec3 ray = ray_to_light(light, receiver, kernel);
    if (ray.z >= 0.0 || !faces(receiver, ray)) continue;
    vec2 lateral = search_lateral(light, view_light, receiver, kernel, ray, z_search);
    vec2 lateral_blocker;
    float z_blocker;
    if (!find_search_blocker(receiver, lateral, lateral_blocker, z_blocker)) continue;
    met += 1.0;
    if (SEARCH_CONE != 0 && !is_in_light_cone(light, view_light, receiver, lateral_blocker, z_blocker, slack)) continue;
    sum += is_harmonic ? 1.0 / z_blocker : z_blocker;
    count += 1.0;
  }
  if (count == 0.0) return receiver.p_light.z;
  return is_harmonic ? count / sum : sum / count;
}
