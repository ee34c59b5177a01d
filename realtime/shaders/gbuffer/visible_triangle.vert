// SPDX-License-Identifier: Apache-2.0
// Pulls triangles and makes each a little larger on screen, so that the rasteriser, which snaps vertices to a grid,
// offers every pixel whose centre the triangle may cover. The fragment shader decides exactly.
#include "camera.glsl"
#ifdef HAS_INSTANCES
#include "instances.glsl"
layout(location = 3) in uint instance_of_vertex;  // const: instance_buffers.h
flat out uint cutout_record;                      // 0: solid
#endif

flat out vec3 a_view;
flat out vec3 b_view;
flat out vec3 c_view;
flat out uint triangle;

// The same operations for the same vertex in every triangle: shared edges must stay shared.
vec3 scaled_view_of(uint vertex) {
#ifdef HAS_INSTANCES
  precise vec3 from_eye = place_world(instances[instance_of_vertex], position_world(vertex)) - frame.eye_world.xyz;
#else
  precise vec3 from_eye = position_world(vertex) - frame.eye_world.xyz;
#endif
  precise vec3 p_view = vec3(dot(right_world.xyz, from_eye) / right_world.w,
                             dot(up_world.xyz, from_eye) / up_world.w, dot(forward_world.xyz, from_eye));
  return p_view;
}

float cross_2d(vec2 a, vec2 b) { return a.x * b.y - a.y * b.x; }

const float kMaxSpike = 1e5;         // of a sharp corner, in units of the growth
const float kMaxReach_px = 8192.0;   // beyond, float screen coordinates are coarser than the growth

// Corner `p_px` of a counter-clockwise triangle after both its edges moved outwards by `growth_px`.
vec2 grown_corner_px(vec2 p_px, vec2 before_px, vec2 after_px, float growth_px) {
  vec2 edge_in = normalize(p_px - before_px);
  vec2 edge_out = normalize(after_px - p_px);
  float sine = max(cross_2d(edge_in, edge_out), 1e-12);
  float spike = min((1.0 - dot(edge_in, edge_out)) / sine, kMaxSpike);
  return p_px + growth_px * (vec2(edge_in.y, -edge_in.x) + spike * edge_in);
}

// Corner 0, 1 or 2 of a triangle around the part of the screen where z >= near, for triangles that cross the near
// plane or reach far outside the screen.
vec2 covering_corner_ndc(vec3 corners_view[3], int corner, float near_world) {
  vec2 low = vec2(1e30), high = vec2(-1e30);
  for (int i = 0; i < 3; ++i) {
    vec3 from = corners_view[i], to = corners_view[(i + 1) % 3];
    if (from.z >= near_world) {
      low = min(low, from.xy / from.z);
      high = max(high, from.xy / from.z);
    }
    if ((from.z >= near_world) != (to.z >= near_world)) {
      vec2 cut = mix(from.xy, to.xy, (near_world - from.z) / (to.z - from.z)) / near_world;
      low = min(low, cut);
      high = max(high, cut);
    }
  }
  vec2 margin = 4.0 / screen_px.xy;
  low = max(low - margin, vec2(-1.0) - margin);
  high = min(high + margin, vec2(1.0) + margin);
  if (any(greaterThanEqual(low, high))) return vec2(2.0);  // off screen: all three corners fall together
  return low + (high - low) * vec2(corner == 1 ? 2.0 : 0.0, corner == 2 ? 2.0 : 0.0);
}

vec2 corner_ndc(vec3 corners_view[3], int corner) {
  float near_world = forward_world.w;
  vec2 half_screen_px = 0.5 * screen_px.xy;
  vec2 p_px[3];
  float reach_px = 0.0;
  bool is_in_front = true;
  for (int i = 0; i < 3; ++i) {
    is_in_front = is_in_front && corners_view[i].z > near_world;
    p_px[i] = corners_view[i].xy / corners_view[i].z * half_screen_px;
    reach_px = max(reach_px, max(abs(p_px[i].x), abs(p_px[i].y)));
  }
  if (!is_in_front || reach_px > kMaxReach_px) return covering_corner_ndc(corners_view, corner, near_world);
  float area_px = cross_2d(p_px[1] - p_px[0], p_px[2] - p_px[0]);
  if (area_px == 0.0) return vec2(2.0);
  int before = (corner + 2) % 3, after = (corner + 1) % 3;
  if (area_px < 0.0) {
    int other = before;
    before = after;
    after = other;
  }
  return grown_corner_px(p_px[corner], p_px[before], p_px[after], screen_px.z) / half_screen_px;
}

// Says which triangle is drawn; returns where it is stored.
uint take_triangle() {
  triangle = uint(gl_VertexID) / 3u;
#ifdef HAS_INSTANCES
  InstanceRecord instance = instances[instance_of_vertex];
  uint of_mesh = triangle;
  triangle = instance.first_shown + of_mesh;
  const uint kRecordWords = 7u;  // const: cutout.glsl
  cutout_record =
      of_mesh < instance.first_cutout ? 0u : instance.first_record + kRecordWords * (of_mesh - instance.first_cutout);
  return instance.first_triangle + of_mesh;
#else
  return triangle;
#endif
}

void main() {
  uvec3 corners = corners_of(take_triangle());
  a_view = scaled_view_of(corners.x);
  b_view = scaled_view_of(corners.y);
  c_view = scaled_view_of(corners.z);
  // Depth is the fragment's business, and so is what is nearer than the near plane.
  gl_Position = vec4(corner_ndc(vec3[3](a_view, b_view, c_view), gl_VertexID % 3), 0.5, 1.0);
}
