// Whether all of a square of texels must come out lit, or all of it blocked, by the extremes of the blocks it touches.
// Conservative: what this knows, single comparisons would have found too.
#include "blocks.glsl"
#include "shadow_map.glsl"

/// Least and largest reversed depth in the blocks of texels low to high. Texels outside the map are empty.
vec2 extremes(sampler2D blocks, LightViewData view, ivec2 low, ivec2 high) {
  bool is_inside = is_in_map(view, low) && is_in_map(view, high);
  ivec2 first = max(low, ivec2(0)) / kBlockTexels;
  ivec2 last = min(high, ivec2(int(view.depth_range.w) - 1)) / kBlockTexels;
  vec2 least_and_largest = vec2(is_inside ? 1.0 : 0.0, 0.0);
  for (int y = first.y; y <= last.y; ++y) {
    for (int x = first.x; x <= last.x; ++x) {
      vec2 block = texelFetch(blocks, ivec2(x, y), 0).rg;
      least_and_largest = vec2(min(least_and_largest.x, block.x), max(least_and_largest.y, block.y));
    }
  }
  return least_and_largest;
}

/// At most what any texel of the square is compared with. The tangent plane's distance has its least value at a corner;
/// its limit on slopes only raises it.
float least_compare_distance(LightViewData view, Receiver receiver, ivec2 low, ivec2 high) {
  float z = receiver.p_light.z;
  for (int i = 0; i < 4 && receiver.has_plane; ++i) {  // const: corners
    vec2 corner = vec2((i & 1) == 0 ? low.x : high.x + 1, (i >> 1) == 0 ? low.y : high.y + 1);
    z = min(z, meeting_distance(view, receiver, lateral_of_texel(view, corner)));
  }
  return z - receiver.bias_world - 1e-5 * receiver.p_light.z;  // const: the rounding of two such distances
}

/// True when all texels from low to high are lit (visibility 1) or all blocked (0).
bool is_known_by_blocks(sampler2D blocks, LightViewData view, Receiver receiver, ivec2 low, ivec2 high,
                        out float visibility) {
  vec2 least_and_largest = extremes(blocks, view, low, high);
  float nearest = distance_of_depth(view, least_and_largest.y);
  float farthest = distance_of_depth(view, least_and_largest.x);
  bool is_lit = least_and_largest.y <= 0.0 || nearest >= receiver.p_light.z - receiver.bias_world;
  bool is_dark = least_and_largest.x > 0.0 && farthest < least_compare_distance(view, receiver, low, high);
  visibility = is_lit ? 1.0 : 0.0;
  return is_lit || is_dark;
}
