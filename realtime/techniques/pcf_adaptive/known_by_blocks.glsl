// SPDX-License-Identifier: Apache-2.0
// Whether a square of texels must come out all lit or all blocked, by the blocks it touches. Conservative: what this
// says, the comparisons would have said. Depths are reversed here, so nearer is larger, and linear in the map's
// coordinates: what holds at the corners of a rectangle holds inside.
#include "blocks.glsl"
#include "shadow_map.glsl"

/// Corner `index` of 4.
ivec2 corner_of(int index, ivec2 low, ivec2 high) {
  return ivec2((index & 1) == 0 ? low.x : high.x, (index >> 1) == 0 ? low.y : high.y);
}

/// By how much distances must differ before their order is certain.
float rounding_world(LightViewData view, Receiver receiver) {
  return 2e-6 * (is_orthographic(view) ? view.depth_range.y : receiver.p_light.z);  // const: some 16 roundings
}

/// Whether comparisons are with the tangent plane or the receiver's own distance, less a constant: all that follows
/// assumes it.
bool is_plain_bias(TapBias taps) {
  return !taps.is_auto && taps.plane != kPlaneAtTap && taps.cone == 0.0;
}

/// Depth of the receiver's tangent plane, also where the light's ray does not meet it; linear in `lateral`.
float depth_of_plane(LightViewData view, Receiver receiver, vec2 lateral) {
  vec3 n = receiver.n_light;
  float near_world = view.depth_range.x;
  float far_world = view.depth_range.y;
  if (is_orthographic(view)) {
    float z = (receiver.plane_distance - dot(n.xy, lateral)) / n.z;
    return (far_world - z) / (far_world - near_world);
  }
  float inverse_distance = dot(n, vec3(lateral, 1.0)) / receiver.plane_distance;
  return near_world * (far_world * inverse_distance - 1.0) / (far_world - near_world);
}

/// Whether no texel from low to high, all of the block from `origin` on, is a blocker. A comparison's depth is at
/// least the receiver's own, and (where the slope is not limited) at least the plane's, each with the bias on top. The
/// bias moves depths least at the receiver, the farthest point compared with.
bool is_lit_block(LightViewData view, Receiver receiver, Block block, ivec2 origin, ivec2 low, ivec2 high) {
  float bias_world = receiver.bias_world - rounding_world(view, receiver);
  float own_depth = depth_of_distance(view, receiver.p_light.z);
  float own_limit = depth_of_distance(view, receiver.p_light.z - bias_world);
  bool follows_plane = receiver.taps.plane != kNoPlane && receiver.slope < 0.9 * kMaxPlaneSlope;  // const: some room
  bool is_behind_plane = follows_plane && bias_world > 0.0;
  bool is_behind_receiver = true;
  for (int i = 0; i < 4; ++i) {  // const: corners
    ivec2 texel = corner_of(i, low, high);
    float depth = dot(block.slope, vec2(texel - origin)) + block.largest;
    float plane_depth = depth_of_plane(view, receiver, lateral_of_texel(view, vec2(texel) + 0.5));
    is_behind_receiver = is_behind_receiver && depth <= own_limit;
    is_behind_plane = is_behind_plane && depth - plane_depth <= own_limit - own_depth;
  }
  return is_behind_receiver || is_behind_plane;
}

/// Whether all texels from low to high are blockers. The limit on the plane's slope only helps; empty texels have
/// depth 0.
bool is_dark_block(LightViewData view, Receiver receiver, Block block, ivec2 origin, ivec2 low, ivec2 high) {
  float bias_world = receiver.bias_world + rounding_world(view, receiver);
  float own_depth = depth_of_distance(view, receiver.p_light.z);
  for (int i = 0; i < 4; ++i) {  // const: corners
    ivec2 texel = corner_of(i, low, high);
    float depth = dot(block.slope, vec2(texel - origin)) + block.least;
    float plane_depth = depth_of_plane(view, receiver, lateral_of_texel(view, vec2(texel) + 0.5));
    float compared = receiver.taps.plane == kNoPlane ? own_depth : max(own_depth, plane_depth);
    if (depth <= depth_of_distance(view, distance_of_depth(view, compared) - bias_world)) return false;
  }
  return true;
}

/// True when all texels from low to high are lit (visibility 1) or all are blockers (0).
bool is_known_by_blocks(sampler2D blocks, LightViewData view, Receiver receiver, ivec2 low, ivec2 high,
                        out float visibility) {
  if (!is_plain_bias(receiver.taps)) return false;
  ivec2 first = max(low, ivec2(0)) / kBlockTexels;
  ivec2 last = min(high, ivec2(int(view.depth_range.w) - 1)) / kBlockTexels;
  bool is_lit = true;
  bool is_dark = is_in_map(view, low) && is_in_map(view, high);  // beside the map nothing blocks
  for (int y = first.y; y <= last.y && (is_lit || is_dark); ++y) {
    for (int x = first.x; x <= last.x && (is_lit || is_dark); ++x) {
      ivec2 origin = kBlockTexels * ivec2(x, y);
      ivec2 block_low = max(low, origin);
      ivec2 block_high = min(high, origin + kBlockTexels - 1);
      Block block = unpack(texelFetch(blocks, ivec2(x, y), 0));
      is_lit = is_lit && is_lit_block(view, receiver, block, origin, block_low, block_high);
      is_dark = is_dark && is_dark_block(view, receiver, block, origin, block_low, block_high);
    }
  }
  visibility = is_lit ? 1.0 : 0.0;
  return is_lit || is_dark;
}
