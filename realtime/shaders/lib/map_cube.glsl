// SPDX-License-Identifier: Apache-2.0
// A cube of shadow maps around the light. Each receiver sees it through a view of its own, `view_light`, whose axis runs
// from the light's centre through the receiver: kernels and distances then know no faces, so nothing changes at their
// edges. For fullscreen passes that read gbuffer.position and see the views `cube` (the six faces).
#include "shadow_map.glsl"

LightViewData view_light;

/// The face a direction from the light's centre goes through: GL's +x, -x, +y, -y, +z, -z.
int face_of(vec3 direction_world) {
  vec3 size = abs(direction_world);
  int axis = size.x >= size.y && size.x >= size.z ? 0 : (size.y >= size.z ? 1 : 2);
  return 2 * axis + (direction_world[axis] < 0.0 ? 1 : 0);
}

/// From the light's centre through the middle of the texel that a direction meets; 1 long along the face's axis.
vec3 through_texel(vec3 direction_world, float texels) {
  mat3 face_from_world = mat3(view_cube[face_of(direction_world)].light_from_world);
  vec3 p = face_from_world * direction_world;
  vec2 texel = clamp(floor(texels * (0.5 * p.xy / p.z + 0.5)), 0.0, texels - 1.0);
  return transpose(face_from_world) * vec3(2.0 * (texel + 0.5) / texels - 1.0, 1.0);
}

/// Distance along the axis of the face that holds it.
float face_distance(vec3 offset_world) {
  vec3 size = abs(offset_world);
  return max(size.x, max(size.y, size.z));
}

/// The view whose axis runs through a point. Its texels are as wide as those of the cube there, and one of them has its
/// middle where the cube's has.
LightViewData view_through(vec3 p_world) {
  LightViewData view = view_cube[0];  // all faces share distances and size
  vec3 z = normalize(p_world - frame.light_center_world.xyz);
  vec3 x = normalize(cross(abs(z.x) < 0.5 ? vec3(1.0, 0.0, 0.0) : vec3(0.0, 1.0, 0.0), z));
  mat3 rotation = transpose(mat3(x, cross(z, x), z));
  view.light_from_world = mat4(rotation);
  view.light_from_world[3].xyz = -rotation * frame.light_center_world.xyz;  // const: the column of the translation
  vec3 own = through_texel(z, view.depth_range.w);
  vec3 own_light = rotation * own;
  float half_width = 1.0 / length(own);
  vec2 corner = own_light.xy / own_light.z - half_width * (1.0 + 1.0 / view.depth_range.w);
  view.lateral_bounds = vec4(corner, corner + 2.0 * half_width);
  return view;
}

/// The direction in the world that a lateral position of the view stands for.
vec3 direction_at(LightViewData view, vec2 lateral) { return transpose(mat3(view.light_from_world)) * vec3(lateral, 1.0); }

/// As find_blocker_at() of a single map, with distances along the view's axis.
bool find_blocker_at(samplerCube map, LightViewData view, Receiver receiver, vec2 lateral, out vec2 lateral_center,
                     out float z_blocker) {
  vec3 direction = through_texel(direction_at(view, lateral), view.depth_range.w);
  float depth_reversed = textureLod(map, direction, 0.0).r;
  if (depth_reversed <= 0.0) return false;
  vec3 p_blocker = mat3(view.light_from_world) * (direction * distance_of_depth(view, depth_reversed));
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
