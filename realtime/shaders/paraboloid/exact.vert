// SPDX-License-Identifier: Apache-2.0
// A square around a triangle's image in a paraboloid's map, in which straight edges are arcs: exact.frag finds them texel by
// texel. Six vertices a triangle.
#include "paraboloid.glsl"
#include "pulled_triangle.glsl"
#include "spaces.glsl"

flat out vec3 a_light;
flat out vec3 b_light;
flat out vec3 c_light;
flat out uint holes;

/// Lowest and highest coordinates, the first above the second beside the map. The cone around the three directions becomes a circle:
/// its rim lies at tan(angle / 2) on the line through its axis. Cones that no place of the map lies in are beside it, like all that is
/// right behind the light; others that hold the direction away from the map, or more than half of all, take the whole square.
vec4 covered(vec3 a, vec3 b, vec3 c) {
  const vec4 kWhole = vec4(-1.0, -1.0, 1.0, 1.0);
  const vec4 kBeside = vec4(1.0, 1.0, -1.0, -1.0);
  const float kMargin_texels = 2.0;  // const: rounding of the angles, and a texel's half
  float margin = kMargin_texels * texel_lateral(VIEW);
  vec3 sum = a + b + c;
  if (dot(sum, sum) < 1e-6) return kWhole;
  vec3 axis = normalize(sum);
  float cos_cone = min(dot(axis, a), min(dot(axis, b), dot(axis, c)));
  if (cos_cone <= 0.0) return kWhole;
  float cone_rad = acos(min(cos_cone, 1.0));
  float axis_rad = acos(clamp(axis.z, -1.0, 1.0));
  float corner_rad = 2.0 * atan(sqrt(2.0) * (1.0 + margin));
  if (axis_rad - cone_rad > corner_rad) return kBeside;
  const float kHalfTurn = 3.1415926;  // const: pi, less its rounding
  if (axis_rad + cone_rad >= kHalfTurn) return kWhole;
  float near_rim = tan(0.5 * (axis_rad - cone_rad));
  float far_rim = tan(0.5 * (axis_rad + cone_rad));
  vec2 outwards = dot(axis.xy, axis.xy) > 0.0 ? normalize(axis.xy) : vec2(1.0, 0.0);
  vec2 center = 0.5 * (near_rim + far_rim) * outwards;
  float radius = 0.5 * (far_rim - near_rim);
  float reach = 1.001 * radius + margin;
  return vec4(max(center - reach, -1.0), min(center + reach, 1.0));
}

void main() {
  PulledTriangle triangle = pulled_triangle();
  a_light = (VIEW.light_from_world * vec4(triangle.a_world, 1.0)).xyz;
  b_light = (VIEW.light_from_world * vec4(triangle.b_world, 1.0)).xyz;
  c_light = (VIEW.light_from_world * vec4(triangle.c_world, 1.0)).xyz;
  holes = triangle.holes;
  vec4 low_high = covered(normalize(a_light), normalize(b_light), normalize(c_light));
  if (any(greaterThan(low_high.xy, low_high.zw))) low_high = vec4(2.0);  // beside the map
  const int kCorners[6] = int[](0, 1, 2, 2, 1, 3);
  int corner = kCorners[pulled_vertex()];
  gl_Position = vec4((corner & 1) == 0 ? low_high.x : low_high.z, (corner & 2) == 0 ? low_high.y : low_high.w, 0.5, 1.0);
}
