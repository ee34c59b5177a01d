// SPDX-License-Identifier: Apache-2.0
// Position, normals and unshadowed irradiance of the triangle each pixel shows.
#include "camera.glsl"
#include "irradiance.glsl"
#ifdef HAS_INSTANCES
#include "instances.glsl"
#endif

layout(binding = 0) uniform usampler2D primitive_id;

layout(location = 0) out vec4 out_position;
layout(location = 1) out vec4 out_normal;
layout(location = 2) out vec4 out_shading_normal;
layout(location = 3) out float out_unshadowed_irradiance;

const uint kNoPrimitive = 0xffffffffu;

struct Hit {
  vec3 p_world;
  vec3 n_world;          // geometric, facing the camera
  vec3 n_shading_world;  // on the same side
};

// A triangle's corners where they stand, and their shading normals if there are any.
struct Corners {
  dvec3 a, b, c;
  vec3 normal_a, normal_b, normal_c;
};

Corners stored_corners(uint triangle) {
  uvec3 corners = corners_of(triangle);
  Corners t;
  t.a = dvec3(position_world(corners.x));
  t.b = dvec3(position_world(corners.y));
  t.c = dvec3(position_world(corners.z));
  t.normal_a = t.normal_b = t.normal_c = vec3(0.0);
  if (has_normals.x == 0) return t;
  t.normal_a = normal_world(corners.x);
  t.normal_b = normal_world(corners.y);
  t.normal_c = normal_world(corners.z);
  return t;
}

#ifdef HAS_INSTANCES
dvec3 placed(InstanceRecord instance, dvec3 p_mesh) {
  dvec4 p = dvec4(p_mesh, 1.0);
  return dvec3(dot(dvec4(instance.row_x), p), dot(dvec4(instance.row_y), p), dot(dvec4(instance.row_z), p));
}

// By the cofactors: right for stretched meshes, too. None mirrors.
vec3 placed_normal(InstanceRecord instance, vec3 n_mesh) {
  vec3 x = instance.row_x.xyz, y = instance.row_y.xyz, z = instance.row_z.xyz;
  return normalize(vec3(dot(cross(y, z), n_mesh), dot(cross(z, x), n_mesh), dot(cross(x, y), n_mesh)));
}

// The last instance whose triangles begin at or before the shown one; they stand in order.
uint instance_of(uint triangle) {
  uint low = 0u, high = uint(instances.length());
  while (high - low > 1u) {
    uint middle = (low + high) / 2u;
    if (instances[middle].first_shown <= triangle) {
      low = middle;
    } else {
      high = middle;
    }
  }
  return low;
}

Corners shown_corners(uint triangle) {
  if (triangle < instances[0].first_shown) return stored_corners(triangle);
  InstanceRecord instance = instances[instance_of(triangle)];
  Corners t = stored_corners(instance.first_triangle + triangle - instance.first_shown);
  t.a = placed(instance, t.a);
  t.b = placed(instance, t.b);
  t.c = placed(instance, t.c);
  if (has_normals.x == 0) return t;
  t.normal_a = placed_normal(instance, t.normal_a);
  t.normal_b = placed_normal(instance, t.normal_b);
  t.normal_c = placed_normal(instance, t.normal_c);
  return t;
}
#else
Corners shown_corners(uint triangle) { return stored_corners(triangle); }
#endif

// In double precision: n . a and n . d lose most of their digits on large triangles seen at a grazing angle.
Hit hit_of(uint triangle, vec2 p_ndc) {
  Corners corners = shown_corners(triangle);
  dvec3 a = corners.a, ab = corners.b - a, ac = corners.c - a;
  dvec3 eye = dvec3(frame.eye_world.xyz) + dvec3(eye_world_low.xyz);
  dvec3 d = dvec3(forward_world.xyz) + dvec3(right_world.xyz) * double(p_ndc.x * right_world.w) +
            dvec3(up_world.xyz) * double(p_ndc.y * up_world.w);
  dvec3 n = cross(ab, ac);
  dvec3 p = eye + d * (dot(n, a - eye) / dot(n, d));

  Hit hit;
  hit.p_world = vec3(p);
  hit.n_world = vec3(n / sqrt(dot(n, n)));
  if (dot(n, d) > 0.0) hit.n_world = -hit.n_world;
  hit.n_shading_world = hit.n_world;
  if (has_normals.x == 0) return hit;
  double scale = 1.0 / dot(n, n);
  float weight_b = float(dot(cross(p - a, ac), n) * scale);
  float weight_c = float(dot(cross(ab, p - a), n) * scale);
  vec3 sum = (1.0 - weight_b - weight_c) * corners.normal_a + weight_b * corners.normal_b + weight_c * corners.normal_c;
  if (!(dot(sum, sum) > 0.0)) return hit;
  hit.n_shading_world = normalize(sum);
  if (dot(hit.n_shading_world, hit.n_world) < 0.0) hit.n_shading_world = -hit.n_shading_world;
  return hit;
}

void main() {
  uint triangle = texelFetch(primitive_id, ivec2(gl_FragCoord.xy), 0).x;
  out_position = vec4(0.0);
  out_normal = vec4(0.0);
  out_shading_normal = vec4(0.0);
  out_unshadowed_irradiance = 0.0;
  if (triangle == kNoPrimitive) return;
  Hit hit = hit_of(triangle, ndc_of_fragment(gl_FragCoord.xy));
  out_position = vec4(hit.p_world, 1.0);
  out_normal = vec4(hit.n_world, 0.0);
  out_shading_normal = vec4(hit.n_shading_world, 0.0);
  out_unshadowed_irradiance = unshadowed_irradiance(hit.p_world, hit.n_shading_world);
}
