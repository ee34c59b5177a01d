// SPDX-License-Identifier: Apache-2.0
// What lies in the shadow of one triangle: a prism from a little behind it to infinity (Everitt and Kilgard 2002), closed and turned
// outwards whichever side of the triangle the light is on. 24 vertices: two caps, and two triangles for each side.
#include "pulled_triangle.glsl"
#include "volume_light.glsl"

/// Behind the triangle; w = 0 at infinity.
vec4 corner_of_volume(vec3 p_world, bool is_far) {
  vec3 away = from_light(p_world);
  return is_far ? vec4(away, 0.0) : vec4(p_world + bias_world * normalize(away), 1.0);
}

void main() {
  PulledTriangle triangle = pulled_triangle();
  vec3 a = triangle.a_world, b = triangle.b_world, c = triangle.c_world;
  bool is_turned = dot(cross(b - a, c - a), from_light(a)) > 0.0;
  vec3 corners[3] = vec3[](a, is_turned ? c : b, is_turned ? b : c);  // counter-clockwise from the light
  int vertex = pulled_vertex();
  int corner = vertex;
  bool is_far = false;
  if (vertex >= 6) {  // const: after the caps
    const int kNext[6] = int[](1, 0, 0, 1, 0, 1);                                 // const: of a side's two corners
    const bool kFar[6] = bool[](false, false, true, false, true, true);
    int side = (vertex - 6) / 6, k = (vertex - 6) % 6;  // const: after the caps, six a side
    corner = (side + kNext[k]) % 3;
    is_far = kFar[k];
  } else if (vertex >= 3) {
    const int kReversed[3] = int[](0, 2, 1);  // const: seen from the other side
    corner = kReversed[vertex - 3];
    is_far = true;
  }
  gl_Position = frame.clip_from_world * corner_of_volume(corners[corner], is_far);
}
