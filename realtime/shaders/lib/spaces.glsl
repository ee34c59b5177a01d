// SPDX-License-Identifier: Apache-2.0
// Spaces of the light and the screen, the GLSL side of core/spaces.h and docs/conventions.md.
// Light space: x tangent, y bitangent, z distance along the light's direction. Lateral coordinates: x/z, y/z
// (perspective) or x, y in world units (orthographic).

/// Continuous pixel position with row 0 on top, from gl_FragCoord.
vec2 pixel_position(vec2 frag_coord, float screen_height_px) {
  return vec2(frag_coord.x, screen_height_px - frag_coord.y);
}

bool is_orthographic(LightViewData view) { return view.depth_range.z > 0.5; }

/// Distance of a stored reversed depth, z = n f / (n + d (f - n)).
float perspective_distance(float depth_reversed, float near_world, float far_world) {
  return near_world * far_world / (near_world + depth_reversed * (far_world - near_world));
}

/// Distance of a stored reversed depth, z = f - d (f - n).
float orthographic_distance(float depth_reversed, float near_world, float far_world) {
  return far_world - depth_reversed * (far_world - near_world);
}

float distance_of_depth(LightViewData view, float depth_reversed) {
  return is_orthographic(view) ? orthographic_distance(depth_reversed, view.depth_range.x, view.depth_range.y)
                               : perspective_distance(depth_reversed, view.depth_range.x, view.depth_range.y);
}

/// The depth that distance_of_depth turns back, within [0, 1].
float depth_of_distance(LightViewData view, float distance_world) {
  float near_world = view.depth_range.x;
  float far_world = view.depth_range.y;
  float share = (far_world - distance_world) / (far_world - near_world);
  return clamp(is_orthographic(view) ? share : share * near_world / max(distance_world, near_world), 0.0, 1.0);
}

vec2 lateral_of(LightViewData view, vec3 p_light) {
  return is_orthographic(view) ? p_light.xy : p_light.xy / p_light.z;
}

/// Map coordinates in texels, a texel's centre at +0.5.
vec2 texel_position(LightViewData view, vec2 lateral) {
  vec2 extent = view.lateral_bounds.zw - view.lateral_bounds.xy;
  return (lateral - view.lateral_bounds.xy) / extent * view.depth_range.w;
}

vec2 lateral_of_texel(LightViewData view, vec2 p_texels) {
  vec2 extent = view.lateral_bounds.zw - view.lateral_bounds.xy;
  return view.lateral_bounds.xy + p_texels / view.depth_range.w * extent;
}

/// Width of a texel in lateral coordinates; the wider side where texels are not square.
float texel_lateral(LightViewData view) {
  vec2 size = (view.lateral_bounds.zw - view.lateral_bounds.xy) / view.depth_range.w;
  return max(size.x, size.y);
}

/// Width of a texel in the world at a distance.
float texel_world(LightViewData view, float distance_world) {
  return texel_lateral(view) * (is_orthographic(view) ? 1.0 : distance_world);
}
