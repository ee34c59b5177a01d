// SPDX-License-Identifier: Apache-2.0
// Percentage-closer filtering over cascades, whose maps are tiles of one texture.
#include "cascade_disk.glsl"

/// Row by row from the bottom, as technique.toml lays them out.
vec2 tile_origin_texels(int tile) {
  int columns = int(shadow_map_size.x / view_light.depth_range.w);
  return view_light.depth_range.w * vec2(tile % columns, tile / columns);
}

/// The share of a blend over four texels around `p_texels` that lies in the tile; the rest is lit, as outside a map of its own.
float share_in_tile(vec2 p_texels) {
  vec2 inside = clamp(min(p_texels, view_light.depth_range.w - p_texels) + 0.5, 0.0, 1.0);
  return inside.x * inside.y;
}

/// Blends reach no other tile: they are made at the nearest place whose four texels are all of this one.
float blended_comparison(vec2 p_texels, float depth_reversed) {
  vec2 p_inside = clamp(p_texels, vec2(0.5), vec2(view_light.depth_range.w - 0.5));
  vec2 uv = (tile_origin_texels(map_layer) + p_inside) * shadow_map_size.zw;
  return mix(1.0, texture(shadow_map, vec3(uv, depth_reversed)), share_in_tile(p_texels));
}
