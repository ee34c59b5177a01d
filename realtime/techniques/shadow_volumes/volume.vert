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

const int kCap = 3;   // const: vertices of a cap
const int kSide = 6;  // const: of a side

void main() {
  PulledTriangle triangle = pulled_triangle();
  vec3 a = triangle.a_world, b = triangle.b_world, c = triangle.c_world;
  bool is_turned = dot(cross(b - a, c - a), from_light(a)) > 0.0;
  vec3 corners[kCap] = vec3[](a, is_turned ? c : b, is_turned ? b : c);  // counter-clockwise from the light
  int vertex = pulled_vertex();
  int corner = vertex;
  bool is_far = false;
  if (vertex >= 2 * kCap) {
    const int kNext[kSide] = int[](1, 0, 0, 1, 0, 1);  // which of the side's two corners
    const bool kFar[kSide] = bool[](false, false, true, false, true, true);
    int side = (vertex - 2 * kCap) / kSide, k = (vertex - 2 * kCap) % kSide;
    corner = (side + kNext[k]) % kCap;
    is_far = kFar[k];
  } else if (vertex >= kCap) {
    const int kReversed[kCap] = int[](0, 2, 1);  // seen from the other side
    corner = kReversed[vertex - kCap];
    is_far = true;
  }
  gl_Position = frame.clip_from_world * corner_of_volume(corners[corner], is_far);
}
