// Reading a shadow map: which texel, how far its surface is, whether it blocks.
#include "receiver.glsl"

bool is_in_map(LightViewData view, ivec2 texel) {
  int size = int(view.depth_range.w);
  return texel.x >= 0 && texel.y >= 0 && texel.x < size && texel.y < size;
}

/// Whether the texel at `lateral` holds a blocker of the receiver; if so `z_blocker` is its distance. Compared at
/// the texel's centre, where the map was sampled. Outside the map and where it is empty nothing blocks.
bool find_blocker(sampler2D map, LightViewData view, Receiver receiver, ivec2 texel, out float z_blocker) {
  if (!is_in_map(view, texel)) return false;
  float depth_reversed = texelFetch(map, texel, 0).r;
  if (depth_reversed <= 0.0) return false;
  z_blocker = distance_of_depth(view, depth_reversed);
  return z_blocker < compare_distance(view, receiver, lateral_of_texel(view, vec2(texel) + 0.5));
}

bool is_blocked(sampler2D map, LightViewData view, Receiver receiver, ivec2 texel) {
  float z_blocker;
  return find_blocker(map, view, receiver, texel, z_blocker);
}

ivec2 texel_at(LightViewData view, vec2 lateral) { return ivec2(floor(texel_position(view, lateral))); }

/// One comparison from the view's viewpoint: 0 behind the surface and where something is nearer.
float hard_visibility(sampler2D map, LightViewData view, Receiver receiver) {
  if (!faces(receiver, to_viewpoint(view, receiver))) return 0.0;
  if (is_behind(view, receiver)) return 1.0;
  return is_blocked(map, view, receiver, texel_at(view, receiver.lateral)) ? 0.0 : 1.0;
}
