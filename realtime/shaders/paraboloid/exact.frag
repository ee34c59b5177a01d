// SPDX-License-Identifier: Apache-2.0
// Distance along the ray through a texel's middle to the triangle, if it meets it: no edge is bent, no depth interpolated.
#include "paraboloid.glsl"
#include "spaces.glsl"
#ifdef HAS_CUTOUTS
#include "cutout.glsl"
#endif

flat in vec3 a_light;
flat in vec3 b_light;
flat in vec3 c_light;
flat in uint holes;

/// Exactly antisymmetric in its points, so that neighbours agree on the edge they share.
vec3 edge_plane(vec3 from, vec3 to) {
  precise vec3 one = from.yzx * to.zxy;
  precise vec3 two = from.zxy * to.yzx;
  return one - two;
}

void main() {
  vec3 direction = paraboloid_direction(lateral_of_texel(VIEW, gl_FragCoord.xy));
  vec3 weights = vec3(dot(direction, edge_plane(b_light, c_light)), dot(direction, edge_plane(c_light, a_light)),
                      dot(direction, edge_plane(a_light, b_light)));
  if (any(lessThan(weights, vec3(0.0))) && any(greaterThan(weights, vec3(0.0)))) discard;
  float sum = weights.x + weights.y + weights.z;
  if (sum == 0.0) discard;
  weights /= sum;
  float distance_world = dot(direction, weights.x * a_light + weights.y * b_light + weights.z * c_light);
  if (distance_world <= 0.0) discard;
#ifdef HAS_CUTOUTS
  if (holes != 0u && is_hole_of_record(holes, weights)) discard;
#endif
  gl_FragDepth = depth_of_distance(VIEW, distance_world);
}
