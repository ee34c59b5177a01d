// SPDX-License-Identifier: Apache-2.0
// A layer of an array of shadow maps, read as shadow_map.glsl reads a single map. What looks at `view_light` and
// `shadow_map` sees the map chosen last.
#include "shadow_map.glsl"

// Begun with something: drivers warn of what only some functions set.
LightViewData view_light = LightViewData(mat4(1.0), mat4(1.0), vec4(0.0), vec4(0.0), vec4(0.0));
int map_layer = 0;

/// As find_blocker() of a single map.
bool find_blocker(sampler2DArray maps, LightViewData view, Receiver receiver, ivec2 texel, out float z_blocker) {
  if (!is_in_map(view, texel)) return false;
  return is_blocker(view, receiver, texel, texelFetch(maps, ivec3(texel, map_layer), 0).r, z_blocker);
}

/// As find_blocker_at() of a single map.
bool find_blocker_at(sampler2DArray maps, LightViewData view, Receiver receiver, vec2 lateral, out vec2 lateral_center,
                     out float z_blocker) {
  ivec2 texel = texel_at(view, lateral);
  lateral_center = lateral_of_texel(view, vec2(texel) + 0.5);
  return find_blocker(maps, view, receiver, texel, z_blocker);
}
