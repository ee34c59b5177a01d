// SPDX-License-Identifier: Apache-2.0
// Soft shadow mapping by backprojection (Guennebaud et al. 2006) onto a bit mask (Schwarz and Stamminger 2007).
#include "light_mask.glsl"
#include "pixel.glsl"
#include "search_bound.glsl"

/// Where the line from the receiver through `lateral` at distance z meets the light's square.
vec2 on_light(AreaLight light, Receiver receiver, vec2 lateral, float z) {
  vec3 p = receiver.p_light;
  if (is_orthographic(view_light)) return (lateral - p.xy) / ((p.z - z) * light.half_extent);
  return (p.xy + (lateral * z - p.xy) * p.z / (p.z - z)) / light.half_extent;
}

/// Widens a side of a patch, at `lateral` on `axis`, to where the neighbour on that side begins.
float widened_to(AreaLight light, Receiver receiver, ivec2 neighbour, vec2 lateral, int axis, float side, bool is_high) {
  float z;
  if (!find_blocker(shadow_map, view_light, receiver, neighbour, z)) return side;
  float other = on_light(light, receiver, lateral, z)[axis];
  return is_high ? max(side, other) : min(side, other);
}

/// The patch of `stride` x `stride` texels from `texel` on.
void cover_patch(AreaLight light, Receiver receiver, ivec2 texel, int stride, inout LightMask mask) {
  float z;
  ivec2 middle = texel + stride / 2;
  if (!find_blocker(shadow_map, view_light, receiver, middle, z)) return;
  vec2 low_lateral = lateral_of_texel(view_light, vec2(texel));
  vec2 high_lateral = lateral_of_texel(view_light, vec2(texel + stride));
  vec2 low = on_light(light, receiver, low_lateral, z);
  vec2 high = on_light(light, receiver, high_lateral, z);
  if (any(lessThan(high, vec2(-1.0))) || any(greaterThan(low, vec2(1.0)))) return;
  if (GAP_FILLING != 0) {
    high.x = widened_to(light, receiver, middle + ivec2(stride, 0), high_lateral, 0, high.x, true);
    high.y = widened_to(light, receiver, middle + ivec2(0, stride), high_lateral, 1, high.y, true);
    low.x = widened_to(light, receiver, middle - ivec2(stride, 0), low_lateral, 0, low.x, false);
    low.y = widened_to(light, receiver, middle - ivec2(0, stride), low_lateral, 1, low.y, false);
  }
  cover(mask, low, high);
}

float visibility_of(Receiver receiver) {
  AreaLight light = kernel_light();
  LightMask mask;
  for (int i = 0; i < mask.words.length(); ++i) mask.words[i] = 0u;
  vec2 low_texels;
  vec2 high_texels;
  float z_search = is_behind(view_light, receiver) ? receiver.p_light.z : nearest_blocker_bound(light, receiver);
  bool has_box = z_search < receiver.p_light.z && find_search_box(light, receiver, z_search, low_texels, high_texels);
  if (!has_box) return open_share(light, receiver, mask);
  ivec2 first = max(ivec2(floor(low_texels)), ivec2(0));
  ivec2 last = min(ivec2(floor(high_texels)), ivec2(int(view_light.depth_range.w) - 1));
  ivec2 extent = last - first + 1;
  int stride = max(1, (max(extent.x, extent.y) + patches - 1) / patches);
  for (int y = first.y; y <= last.y; y += stride) {
    for (int x = first.x; x <= last.x; x += stride) cover_patch(light, receiver, ivec2(x, y), stride, mask);
  }
  return open_share(light, receiver, mask);
}

void main() {
  Receiver receiver;
  out_visibility = fetch_receiver(receiver) ? visibility_of(receiver) : 1.0;
}
