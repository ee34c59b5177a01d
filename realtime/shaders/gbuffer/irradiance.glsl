// SPDX-License-Identifier: Apache-2.0
// Irradiance of the whole light with nothing in its way: the mean of scenes/light.h LightSample::irradiance_weight in
// the measure that geometric visibility averages over, by Gauss quadrature over the part above the receiver's horizon.

const int kRect = 0, kDisk = 1, kSphere = 2, kSun = 3;
const float kPi = 3.14159265358979;

// Eight-point Gauss-Legendre rule on [-1,1], symmetric (Abramowitz and Stegun, table 25.4).
const int kNodes = 8;
const vec4 kNodeAt = vec4(0.18343464249565, 0.52553240991633, 0.79666647741363, 0.96028985649754);
const vec4 kNodeWeight = vec4(0.36268378337836, 0.31370664587789, 0.22238103445337, 0.10122853629038);

float node_at(int i) { return (i & 1) == 0 ? kNodeAt[i / 2] : -kNodeAt[i / 2]; }
float node_weight(int i) { return kNodeWeight[i / 2]; }

// The light as a flat patch around the receiver: the direction of lateral (a, b) is center + a * per_a + b * per_b,
// (a, b) in [-1,1]^2, or in the unit disk when round; weight = strength * (n . direction) / |direction|^falloff.
struct LightPatch {
  vec3 center, per_a, per_b;
  float strength;
  bool is_round, is_sun;
};

LightPatch sphere_patch(vec3 to_center_world, float radius_world) {
  float outside = dot(to_center_world, to_center_world) - radius_world * radius_world;
  float tan_half_angle = outside > 0.0 ? radius_world * inversesqrt(outside) : 0.0;
  vec3 axis = normalize(to_center_world);
  vec3 other = abs(axis.x) < 0.5 ? vec3(1.0, 0.0, 0.0) : vec3(0.0, 1.0, 0.0);
  vec3 tangent = normalize(cross(other, axis));
  // A tan-plane element's solid angle is its area / length^3; the other power comes from the cosine.
  float disk_area = kPi * tan_half_angle * tan_half_angle;
  return LightPatch(axis, tan_half_angle * tangent, tan_half_angle * cross(axis, tangent), disk_area, true, false);
}

LightPatch light_patch(vec3 p_world) {
  vec3 to_center_world = frame.light_center_world.xyz - p_world;
  int type = frame.light_type.x;
  if (type == kSphere) return sphere_patch(to_center_world, frame.light_extent.x);
  vec3 per_a = frame.light_extent.x * frame.light_tangent_world.xyz;
  vec3 per_b = frame.light_extent.y * frame.light_bitangent_world.xyz;
  vec3 direction_world = frame.light_direction_world.xyz;
  if (type == kSun) return LightPatch(-direction_world, per_a, per_b, 1.0, true, true);
  float area_world = (type == kRect ? 4.0 : kPi) * frame.light_extent.x * frame.light_extent.y;
  float in_front_world = max(0.0, -dot(direction_world, to_center_world));
  return LightPatch(to_center_world, per_a, per_b, area_world * in_front_world, type == kDisk, false);
}

float patch_weight(LightPatch light, vec3 n_world, vec2 lateral) {
  vec3 direction = light.center + lateral.x * light.per_a + lateral.y * light.per_b;
  float length_squared = dot(direction, direction);
  float falloff = light.is_sun ? sqrt(length_squared) : length_squared * length_squared;
  return light.strength * max(0.0, dot(n_world, direction)) / falloff;
}

// Mean over the disk. u runs along the gradient of the cosine, so the horizon is the line u = u_horizon;
// u = cos(phi), v = w sin(phi) makes the integrand smooth up to the rim.
float disk_mean(LightPatch light, vec3 n_world, float cosine_at_center, vec2 gradient) {
  float slope = length(gradient);
  vec2 along = slope > 0.0 ? gradient / slope : vec2(1.0, 0.0);
  float u_horizon = slope > 0.0 ? clamp(-cosine_at_center / slope, -1.0, 1.0) : -sign(cosine_at_center);
  float half_range = 0.5 * acos(u_horizon);
  float sum = 0.0;
  for (int i = 0; i < kNodes; ++i) {
    float phi = half_range * (1.0 + node_at(i));
    float u = cos(phi), v_max = sin(phi);
    float row = 0.0;
    for (int j = 0; j < kNodes; ++j) {
      float v = v_max * node_at(j);
      row += node_weight(j) * patch_weight(light, n_world, u * along + v * vec2(-along.y, along.x));
    }
    sum += node_weight(i) * v_max * v_max * row;
  }
  return sum * half_range / kPi;
}

// The part of [-1,1] where at_zero + slope * t > 0.
vec2 positive_part(float at_zero, float slope) {
  if (slope == 0.0) return at_zero > 0.0 ? vec2(-1.0, 1.0) : vec2(0.0);
  float root = clamp(-at_zero / slope, -1.0, 1.0);
  return slope > 0.0 ? vec2(root, 1.0) : vec2(-1.0, root);
}

// Mean over [-1,1]^2. The outer variable is the one the cosine changes less with: fewer kinks in its integrand.
float square_mean(LightPatch light, vec3 n_world, float cosine_at_center, vec2 gradient) {
  bool is_outer_a = abs(gradient.x) <= abs(gradient.y);
  vec2 slopes = is_outer_a ? gradient : gradient.yx;  // outer, inner
  vec2 outer_range = positive_part(cosine_at_center + abs(slopes.y), slopes.x);
  float outer_half = 0.5 * (outer_range.y - outer_range.x);
  float sum = 0.0;
  for (int i = 0; i < kNodes; ++i) {
    float outer = outer_range.x + outer_half * (1.0 + node_at(i));
    vec2 inner_range = positive_part(cosine_at_center + slopes.x * outer, slopes.y);
    float inner_half = 0.5 * (inner_range.y - inner_range.x);
    float row = 0.0;
    for (int j = 0; j < kNodes; ++j) {
      float inner = inner_range.x + inner_half * (1.0 + node_at(j));
      row += node_weight(j) * patch_weight(light, n_world, is_outer_a ? vec2(outer, inner) : vec2(inner, outer));
    }
    sum += node_weight(i) * inner_half * row;
  }
  return sum * outer_half / 4.0;
}

#include "near_light.glsl"

float unshadowed_irradiance(vec3 p_world, vec3 n_world) {
  if (is_near_light(p_world)) return near_irradiance(p_world, n_world);
  LightPatch light = light_patch(p_world);
  if (!(light.strength > 0.0)) return 0.0;
  float cosine_at_center = dot(n_world, light.center);
  vec2 gradient = vec2(dot(n_world, light.per_a), dot(n_world, light.per_b));
  if (light.is_round) return disk_mean(light, n_world, cosine_at_center, gradient);
  return square_mean(light, n_world, cosine_at_center, gradient);
}
