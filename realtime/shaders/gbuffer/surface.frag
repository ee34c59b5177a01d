// SPDX-License-Identifier: Apache-2.0
// Position, normals and unshadowed irradiance of the triangle each pixel shows.
#include "camera.glsl"
#include "irradiance.glsl"

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

// In double precision: n . a and n . d lose most of their digits on large triangles seen at a grazing angle.
Hit hit_of(uint triangle, vec2 p_ndc) {
  uvec3 corners = corners_of(triangle);
  dvec3 a = dvec3(position_world(corners.x));
  dvec3 ab = dvec3(position_world(corners.y)) - a;
  dvec3 ac = dvec3(position_world(corners.z)) - a;
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
  vec3 sum = (1.0 - weight_b - weight_c) * normal_world(corners.x) + weight_b * normal_world(corners.y) +
             weight_c * normal_world(corners.z);
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
