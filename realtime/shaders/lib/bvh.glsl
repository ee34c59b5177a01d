// SPDX-License-Identifier: Apache-2.0
// Rays through the scene's triangles, for passes that read scene.positions, scene.triangles and scene.bvh. Holes of cut-outs let
// rays through; instances count where they stand. Layout: realtime/scene_data/bvh.h.
#if !defined(HAS_SCENE_POSITIONS) || !defined(HAS_SCENE_TRIANGLES) || !defined(HAS_SCENE_BVH)
#error bvh.glsl needs reads = ["scene.positions", "scene.triangles", "scene.bvh"]
#endif
#ifdef SCENE_HAS_CUTOUTS
#include "cutout.glsl"
#ifdef SCENE_HAS_INSTANCES
#include "instances.glsl"
#endif
#endif

const uint kBvhNone = 0xffffffffu;
const uint kBvhLeave = 0xfffffffeu;     // const: on the stack, where an instance's tree ends
const uint kBvhTriangle = 0x80000000u;  // const: scene_data/bvh.h
const uint kBvhInstance = 0xc0000000u;  // const: scene_data/bvh.h
const uint kBvhRows = 4u;               // const: scene_data/bvh.h
const int kBvhStack = 120;              // const: two trees of kBoxTreeDepth, the node over both, the way back

struct BvhRay {
  vec3 origin;
  vec3 direction;
  vec3 inverse;  // of the direction, finite
};

struct BvhHit {
  float t;        // in lengths of the direction
  uint triangle;  // as scene.triangles counts; kBvhNone: nothing is hit
  uint instance;  // kBvhNone: a triangle of the scene's own
};

BvhRay bvh_ray(vec3 origin, vec3 direction) {
  const float kLeast = 1e-20;  // const: no box is so small that a ray so steep could miss it
  vec3 finite = mix(direction, vec3(kLeast), lessThan(abs(direction), vec3(kLeast)));
  return BvhRay(origin, direction, 1.0 / finite);
}

/// Slabs, grown by what rounding may take from them (Ize 2013: 1 + 2 gamma(3)). `t_enter`: where the ray comes in.
bool bvh_meets_box(BvhRay ray, vec3 low, vec3 high, float t_max, out float t_enter) {
  const float kGrown = 1.0000004;  // const: 1 + 6 roundings of a float
  vec3 to_low = (low - ray.origin) * ray.inverse, to_high = (high - ray.origin) * ray.inverse;
  vec3 enter = min(to_low, to_high), leave = max(to_low, to_high);
  t_enter = max(max(enter.x, enter.y), max(enter.z, 0.0));
  float t_leave = min(min(leave.x, leave.y), min(leave.z, t_max));
  return t_enter <= kGrown * t_leave;
}

/// Of one edge: the same number but for its sign whichever triangle the edge is of, so that no ray slips through between two.
float bvh_edge(vec3 from, vec3 to, vec3 direction) {
  precise vec3 normal = cross(to - from, to + from);
  precise float side = dot(normal, direction);
  return side;
}

/// Corners relative to the ray's origin. `weights`: of the corners where it is hit, with sum 1.
bool bvh_meets_triangle(vec3 a, vec3 b, vec3 c, vec3 direction, float t_max, out float t, out vec3 weights) {
  vec3 sides = vec3(bvh_edge(b, c, direction), bvh_edge(c, a, direction), bvh_edge(a, b, direction));
  bool has_negative = any(lessThan(sides, vec3(0.0))), has_positive = any(greaterThan(sides, vec3(0.0)));
  if (has_negative == has_positive) return false;  // passes by, or lies in the triangle's plane
  vec3 normal = cross(b - a, c - a);
  t = dot(normal, a) / dot(normal, direction);
  weights = sides / (sides.x + sides.y + sides.z);
  return t > 0.0 && t < t_max;
}

vec3 bvh_position(uint triangle, uint corner) {
  const uint kWords = 3u;  // const: of a triangle, and of a position
  uint at = kWords * scene_triangles[kWords * triangle + corner];
  return vec3(scene_positions[at], scene_positions[at + 1u], scene_positions[at + 2u]);
}

bool bvh_is_hole(uint triangle, uint instance, vec3 weights) {
#ifdef SCENE_HAS_CUTOUTS
  if (instance == kBvhNone) return is_hole_of(triangle, weights);
#ifdef SCENE_HAS_INSTANCES
  InstanceRecord record = instances[instance];
  uint of_mesh = triangle - record.first_triangle;
  if (of_mesh < record.first_cutout) return false;
  return is_hole_of_record(record.first_record + kRecordWords * (of_mesh - record.first_cutout), weights);
#endif
#endif
  return false;
}

bool bvh_hits(BvhRay ray, uint triangle, uint instance, inout BvhHit hit) {
  vec3 a = bvh_position(triangle, 0u) - ray.origin, b = bvh_position(triangle, 1u) - ray.origin;
  vec3 c = bvh_position(triangle, 2u) - ray.origin;
  float t;
  vec3 weights;
  if (!bvh_meets_triangle(a, b, c, ray.direction, hit.t, t, weights)) return false;
  if (bvh_is_hole(triangle, instance, weights)) return false;
  hit = BvhHit(t, triangle, instance);
  return true;
}

#ifdef SCENE_HAS_INSTANCES
/// The ray as a mesh sees it; distances along it stay.
BvhRay bvh_ray_in_mesh(BvhRay ray, uint place) {
  vec4 x = uintBitsToFloat(scene_bvh[place]), y = uintBitsToFloat(scene_bvh[place + 1u]);
  vec4 z = uintBitsToFloat(scene_bvh[place + 2u]);
  vec4 origin = vec4(ray.origin, 1.0);
  return bvh_ray(vec3(dot(x, origin), dot(y, origin), dot(z, origin)),
                 vec3(dot(x.xyz, ray.direction), dot(y.xyz, ray.direction), dot(z.xyz, ray.direction)));
}
#endif

/// The nearest hit between the origin and t_max lengths of `direction`; with `any` whichever is found first.
BvhHit bvh_trace(vec3 origin, vec3 direction, float t_max, bool any_hit) {
  BvhRay ray = bvh_ray(origin, direction);
  BvhHit hit = BvhHit(t_max, kBvhNone, kBvhNone);
  uint instance = kBvhNone;
  uint stack[kBvhStack];
  int depth = 0;
  uint link = scene_bvh[0].x;
  while (link != kBvhNone) {
    if (link < kBvhTriangle) {
      uint at = kBvhRows * link;
      uvec4 low_a = scene_bvh[at], low_b = scene_bvh[at + 2u];
      vec3 high_a = uintBitsToFloat(scene_bvh[at + 1u].xyz);
      vec3 high_b = uintBitsToFloat(scene_bvh[at + kBvhRows - 1u].xyz);
      float t_a, t_b;
      bool in_a = bvh_meets_box(ray, uintBitsToFloat(low_a.xyz), high_a, hit.t, t_a);
      bool in_b = bvh_meets_box(ray, uintBitsToFloat(low_b.xyz), high_b, hit.t, t_b);
      if (in_a && in_b) stack[depth++] = t_a <= t_b ? low_b.w : low_a.w;
      if (in_a || in_b) {
        link = in_a && (!in_b || t_a <= t_b) ? low_a.w : low_b.w;
        continue;
      }
    } else if (link < kBvhInstance) {
      if (bvh_hits(ray, link - kBvhTriangle, instance, hit) && any_hit) return hit;
    }
#ifdef SCENE_HAS_INSTANCES
    else if (link == kBvhLeave) {
      ray = bvh_ray(origin, direction);
      instance = kBvhNone;
    } else {
      uint at = kBvhRows * (link - kBvhInstance);
      ray = bvh_ray_in_mesh(ray, at);
      instance = scene_bvh[at + kBvhRows - 1u].y;
      stack[depth++] = kBvhLeave;
      link = scene_bvh[at + kBvhRows - 1u].x;
      continue;
    }
#endif
    link = depth > 0 ? stack[--depth] : kBvhNone;
  }
  return hit;
}

/// The nearest triangle that the ray meets before t_max lengths of `direction`.
BvhHit nearest_hit(vec3 origin, vec3 direction, float t_max) { return bvh_trace(origin, direction, t_max, false); }

/// Whether any triangle is met there.
bool is_any_hit(vec3 origin, vec3 direction, float t_max) {
  return bvh_trace(origin, direction, t_max, true).triangle != kBvhNone;
}
