// SPDX-License-Identifier: Apache-2.0
// Two paraboloids of shadow maps around the light (Brabec et al. 2002). As with map_cube.glsl each receiver sees them through a view
// of its own, `view_light`, whose axis runs from the light's centre through the receiver: kernels and distances know no halves.
// For fullscreen passes that read gbuffer.position and see the views `halves`.
#include "paraboloid.glsl"
#include "shadow_map.glsl"

LightViewData view_light;

/// The half a direction from the light's centre lies in.
int half_of(vec3 direction_world) {
  return (mat3(view_halves[0].light_from_world) * direction_world).z >= 0.0 ? 0 : 1;
}

/// The texel of its half that a unit direction meets.
ivec2 texel_through(vec3 direction_world) {
  LightViewData view = view_halves[half_of(direction_world)];
  vec2 place = paraboloid_place(mat3(view.light_from_world) * direction_world);
  return clamp(ivec2(floor(texel_position(view, place))), ivec2(0), ivec2(int(view.depth_range.w) - 1));
}

/// From the light's centre through the middle of a texel, a unit long.
vec3 through_texel(int of_half, ivec2 texel) {
  LightViewData view = view_halves[of_half];
  return transpose(mat3(view.light_from_world)) * paraboloid_direction(lateral_of_texel(view, vec2(texel) + 0.5));
}

/// The view whose axis runs through a point. Its texels are as wide as those of the map there, and one of them has its
/// middle where the map's has.
LightViewData view_through(vec3 p_world) {
  LightViewData view = view_halves[0];  // both share distances and size
  vec3 z = normalize(p_world - frame.light_center_world.xyz);
  vec3 x = normalize(cross(abs(z.x) < 0.5 ? vec3(1.0, 0.0, 0.0) : vec3(0.0, 1.0, 0.0), z));
  mat3 rotation = transpose(mat3(x, cross(z, x), z));
  view.light_from_world = mat4(rotation);
  view.light_from_world[3].xyz = -rotation * frame.light_center_world.xyz;  // const: the column of the translation
  int own_half = half_of(z);
  float along_axis = (mat3(view_halves[own_half].light_from_world) * z).z;
  vec3 own_light = rotation * through_texel(own_half, texel_through(z));
  float half_width = 1.0 + along_axis;  // a place's step is 2 / (1 + r^2) = 1 + d.z of angle
  vec2 corner = own_light.xy / own_light.z - half_width * (1.0 + 1.0 / view.depth_range.w);
  view.lateral_bounds = vec4(corner, corner + 2.0 * half_width);
  return view;
}

/// The unit direction in the world that a lateral position of the view stands for.
vec3 direction_at(LightViewData view, vec2 lateral) {
  return transpose(mat3(view.light_from_world)) * normalize(vec3(lateral, 1.0));
}

/// As find_blocker_at() of a single map, with distances along the view's axis.
bool find_blocker_at(sampler2DArray map, LightViewData view, Receiver receiver, vec2 lateral, out vec2 lateral_center,
                     out float z_blocker) {
  vec3 direction = direction_at(view, lateral);
  int of_half = half_of(direction);
  ivec2 texel = texel_through(direction);
  float depth_reversed = texelFetch(map, ivec3(texel, of_half), 0).r;
  if (depth_reversed <= 0.0) return false;
  vec3 p_blocker = mat3(view.light_from_world) * (through_texel(of_half, texel) * distance_of_depth(view, depth_reversed));
  z_blocker = p_blocker.z;
  lateral_center = p_blocker.xy / p_blocker.z;
  return z_blocker > 0.0 && z_blocker < compare_distance(view, receiver, lateral_center);
}

/// Turns `view_light` to this pixel's surface point; nothing that uses it works before. False on the background.
bool face_pixel() {
  vec4 position = texelFetch(gbuffer_position, ivec2(gl_FragCoord.xy), 0);
  view_light = view_through(position.xyz);
  return position.w != 0.0;
}
