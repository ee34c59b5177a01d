// SPDX-License-Identifier: Apache-2.0
// Percentage-closer filtering over cascades, whose maps are layers of an array.
#include "cascade_disk.glsl"

float blended_comparison(vec2 p_texels, float depth_reversed) {
  vec2 uv = p_texels / view_light.depth_range.w;
  return texture(shadow_map, vec4(uv, float(map_layer), depth_reversed));
}
