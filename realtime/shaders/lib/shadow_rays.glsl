// SPDX-License-Identifier: Apache-2.0
// Rays from a surface point to points of the light, for passes that read scene.positions, scene.triangles and scene.bvh in
// techniques with the parameters of the group shadow_rays.
#include "area_light.glsl"
#include "bvh.glsl"

/// From a point to the light's point that `square` in [0,1)^2 names, uniform over its area (sun: a direction of unit drop).
vec3 light_ray(vec3 p_world, vec2 square) {
  vec2 kernel = frame.light_type.x == kRect ? 2.0 * square - 1.0 : concentric_disk(square);
  vec2 offset = kernel * frame.light_extent.xy;
  vec3 across = offset.x * frame.light_tangent_world.xyz + offset.y * frame.light_bitangent_world.xyz;
  if (frame.light_type.x == kSun) return across - frame.light_direction_world.xyz;
  vec3 from_center = p_world - frame.light_center_world.xyz;
  if (frame.light_type.x == kSphere) across = point_of_sphere(from_center, frame.light_extent.x, kernel);
  return across - from_center;
}

/// Where a ray comes to the light, in lengths of the ray: a sphere's surface lies before the disk that its points are of.
float light_ray_end(vec3 p_world, vec3 ray) {
  const float kFar = 1e30;  // const: beyond any scene, squares of which are not taken
  if (frame.light_type.x == kSun) return kFar;
  if (frame.light_type.x != kSphere) return 1.0;
  vec3 from_center = p_world - frame.light_center_world.xyz;
  float center2 = dot(from_center, from_center), radius = frame.light_extent.x;
  float q = center2 / dot(ray, ray);
  return q * (1.0 - sqrt(max(0.0, 1.0 - (1.0 - radius * radius / center2) / q)));
}

/// Whether the light's point `square` is seen from a surface point. Not from behind its surface.
bool is_light_seen(vec3 p_world, vec3 n_world, vec2 square) {
  vec3 ray = light_ray(p_world, square);
  if (dot(ray, n_world) <= 0.0) return false;
  float end = light_ray_end(p_world, ray) - ray_offset_world / length(ray);
  return !is_any_hit(p_world + ray_offset_world * n_world, ray, end);
}
