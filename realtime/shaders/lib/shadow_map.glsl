// SPDX-License-Identifier: Apache-2.0
// Reading a shadow map: which texel, how far its surface is, whether it blocks.
#include "receiver.glsl"

bool is_in_map(LightViewData view, ivec2 texel) {
  int size = int(view.depth_range.w);
  return texel.x >= 0 && texel.y >= 0 && texel.x < size && texel.y < size;
}

/// Whether `depth_reversed`, which `texel` holds, is a blocker of the receiver; if so `z_blocker` is its distance.
/// Compared at the texel's centre, where the map was sampled. Where the map is empty nothing blocks.
bool is_blocker(LightViewData view, Receiver receiver, ivec2 texel, float depth_reversed, out float z_blocker) {
  if (depth_reversed <= 0.0) return false;
  z_blocker = distance_of_depth(view, depth_reversed);
  return z_blocker < compare_distance(view, receiver, lateral_of_texel(view, vec2(texel) + 0.5));
}

/// The same of the texel in `map`. Outside the map nothing blocks.
bool find_blocker(sampler2D map, LightViewData view, Receiver receiver, ivec2 texel, out float z_blocker) {
  if (!is_in_map(view, texel)) return false;
  return is_blocker(view, receiver, texel, texelFetch(map, texel, 0).r, z_blocker);
}

bool is_blocked(sampler2D map, LightViewData view, Receiver receiver, ivec2 texel) {
  float z_blocker;
  return find_blocker(map, view, receiver, texel, z_blocker);
}

ivec2 texel_at(LightViewData view, vec2 lateral) { return ivec2(floor(texel_position(view, lateral))); }

/// The same of the texel that holds `lateral`, and where its centre lies.
bool find_blocker_at(sampler2D map, LightViewData view, Receiver receiver, vec2 lateral, out vec2 lateral_center,
                     out float z_blocker) {
  ivec2 texel = texel_at(view, lateral);
  lateral_center = lateral_of_texel(view, vec2(texel) + 0.5);
  return find_blocker(map, view, receiver, texel, z_blocker);
}

/// The comparisons of the four texels around `p_texels`, weighted as bilinear filtering weighs them: compared first,
/// each at its own texel's centre, then blended.
float bilinear_lit(sampler2D map, LightViewData view, Receiver receiver, vec2 p_texels) {
  vec2 low = floor(p_texels - 0.5);
  vec2 share = p_texels - 0.5 - low;
  vec4 lit = vec4(1.0);
  for (int i = 0; i < 4; ++i) {  // const: the corners of a square
    if (is_blocked(map, view, receiver, ivec2(low) + ivec2(i & 1, i >> 1))) lit[i] = 0.0;
  }
  vec2 rows = mix(lit.xz, lit.yw, share.x);
  return mix(rows.x, rows.y, share.y);
}

/// A tap at a place between texels: the comparison of the texel it lies in, or the bilinear blend.
float lit_at(sampler2D map, LightViewData view, Receiver receiver, vec2 p_texels, bool is_bilinear) {
  if (is_bilinear) return bilinear_lit(map, view, receiver, p_texels);
  return is_blocked(map, view, receiver, ivec2(floor(p_texels))) ? 0.0 : 1.0;
}

/// One comparison from the view's viewpoint: 0 behind the surface and where something is nearer.
float hard_visibility(sampler2D map, LightViewData view, Receiver receiver) {
  float known;
  if (is_known(view, receiver, known)) return known;
  return is_blocked(map, view, receiver, texel_at(view, receiver.lateral)) ? 0.0 : 1.0;
}
