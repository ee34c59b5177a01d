// SPDX-License-Identifier: Apache-2.0
// Twin of scenes/near_light.h: irradiance from lights that are near for their size, in closed form.

bool is_near_light(vec3 p_world) {
  int type = frame.light_type.x;
  if (type == kSun) return false;
  vec3 offset = p_world - frame.light_center_world.xyz;
  if (type == kSphere) return length(offset) < 2.0 * frame.light_extent.x;
  return dot(offset, frame.light_direction_world.xyz) < max(frame.light_extent.x, frame.light_extent.y);
}

const float kEdgeOn = 1e-6;  // const: as in scenes/near_light.cpp

// Lambert's term of the edge from a to b.
float edge_irradiance(vec3 a, vec3 b, vec3 n_world) {
  vec3 normal = cross(a, b);
  float sine = length(normal);
  return sine > 0.0 ? atan(sine, dot(a, b)) * dot(normal, n_world) / sine : 0.0;
}

// A corner of the outline as seen from the receiver; a disk is a polygon of the same area.
const int kDiskCorners = 64;  // const: as in scenes/near_light.cpp
vec3 outline_corner(vec3 to_center, int i) {
  vec3 per_a = frame.light_extent.x * frame.light_tangent_world.xyz;
  vec3 per_b = frame.light_extent.y * frame.light_bitangent_world.xyz;
  if (frame.light_type.x == kRect) {
    vec2 corner = vec2((i & 2) == ((i & 1) << 1) ? -1.0 : 1.0, (i & 2) == 0 ? -1.0 : 1.0);
    return to_center + corner.x * per_a + corner.y * per_b;
  }
  const float kStep = 2.0 * kPi / float(kDiskCorners);
  float angle = kStep * (float(i) + 0.5);
  return to_center + sqrt(kStep / sin(kStep)) * (cos(angle) * per_a + sin(angle) * per_b);
}

// A convex outline cut by the horizon: it goes down at one place and comes up at one.
float outline_irradiance(vec3 to_center, vec3 n_world) {
  int corners = frame.light_type.x == kRect ? 4 : kDiskCorners;
  float sum = 0.0;
  vec3 down = vec3(0.0), up = vec3(0.0);
  vec3 from = outline_corner(to_center, corners - 1);
  for (int i = 0; i < corners; ++i) {
    vec3 to = outline_corner(to_center, i);
    float h0 = dot(n_world, from), h1 = dot(n_world, to);
    vec3 cut = from + (to - from) * (h0 / (h0 - h1));
    bool is_cut = (h0 > 0.0) != (h1 > 0.0);
    if (is_cut && h0 > 0.0) down = cut;
    if (is_cut && h1 > 0.0) up = cut;
    if (h0 > 0.0 || h1 > 0.0)
      sum += edge_irradiance(h0 > 0.0 ? from : cut, h1 > 0.0 ? to : cut, n_world);
    from = to;
  }
  return 0.5 * abs(sum + edge_irradiance(down, up, n_world));
}

float sphere_irradiance(vec3 to_center, vec3 n_world) {
  float distance = length(to_center), h = distance / frame.light_extent.x;
  if (!(h > 1.0)) return 0.0;
  float cosine = dot(n_world, to_center) / distance;
  float cut = 1.0 - h * h * cosine * cosine;
  if (cut <= 0.0) return cosine > 0.0 ? kPi * cosine / (h * h) : 0.0;
  float beyond = h * h - 1.0;
  float root = clamp(-cosine * sqrt(beyond / (1.0 - cosine * cosine)), -1.0, 1.0);
  float cap = cosine * acos(root) - sqrt(cut * beyond);
  return max(0.0, cap / (h * h) + atan(sqrt(cut / beyond)));
}

float near_irradiance(vec3 p_world, vec3 n_world) {
  vec3 to_center = frame.light_center_world.xyz - p_world;
  if (frame.light_type.x == kSphere) return sphere_irradiance(to_center, n_world);
  float height_world = -dot(to_center, frame.light_direction_world.xyz);
  if (height_world <= kEdgeOn * max(frame.light_extent.x, frame.light_extent.y)) return 0.0;
  return outline_irradiance(to_center, n_world);
}
