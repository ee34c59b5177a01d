// SPDX-License-Identifier: Apache-2.0
// The light as a set of rays from a receiver, for kernels shaped like the light. Needs a view from the light's
// centre (light space = the light's own frame).
#include "receiver.glsl"
#include "sampling.glsl"

const int kRect = 0;    // const: FrameData.light_type
const int kSphere = 2;  // const: FrameData.light_type
const int kSun = 3;     // const: FrameData.light_type

struct AreaLight {
  int type;
  vec2 half_extent;  // FrameData.light_extent.xy times scale
  float scale;
};

/// Point `index` of `count` over the light: the square [-1,1]^2 for rect, the unit disk otherwise. `noise` in
/// [0,1)^2 shifts the square (Cranley and Patterson 1976) or turns the disk.
vec2 kernel_point(AreaLight light, int index, int count, vec2 noise) {
  if (light.type == kRect) return 2.0 * fract(hammersley(index, count) + noise) - 1.0;
  return vogel_disk(index, count, kTwoPi * noise.x);
}

/// 1 on the light's rim, 0 at its centre.
float kernel_radius(AreaLight light, vec2 kernel) {
  return light.type == kRect ? max(abs(kernel.x), abs(kernel.y)) : length(kernel);
}

/// Moves a kernel point of radius r (uniform in area: r^2 is a fraction u of the points) to radius u^focus: 0.5 leaves
/// it, more crowds the middle, where the rays of small penumbrae are.
vec2 focused(AreaLight light, vec2 kernel, float focus) {
  float radius = kernel_radius(light, kernel);
  return radius > 0.0 ? kernel * pow(radius, 2.0 * focus - 1.0) : kernel;
}

/// A sphere shows every receiver a disk that faces it, scaled to span the sphere's cone: r / sqrt(1 - (r/d)^2).
vec3 point_of_sphere(vec3 p_light, float radius, vec2 kernel) {
  float distance2 = dot(p_light, p_light);
  vec3 axis = p_light * inversesqrt(distance2);
  vec3 helper = abs(axis.x) < 0.5 ? vec3(1.0, 0.0, 0.0) : vec3(0.0, 1.0, 0.0);
  vec3 tangent = normalize(cross(axis, helper));
  float spanning = radius * inversesqrt(max(1.0 - radius * radius / distance2, 1e-6));  // const: inside the sphere
  return spanning * (kernel.x * tangent + kernel.y * cross(axis, tangent));
}

/// From the receiver to the light point that `kernel` names (sun: a direction of unit drop).
vec3 ray_to_light(AreaLight light, Receiver receiver, vec2 kernel) {
  if (light.type == kSun) return vec3(kernel * light.half_extent, -1.0);
  if (light.type == kSphere) return point_of_sphere(receiver.p_light, light.half_extent.x, kernel) - receiver.p_light;
  return vec3(kernel * light.half_extent, 0.0) - receiver.p_light;
}

/// Where the map sees the ray's point at distance z. Around the receiver's own position this is the kernel
/// h (1/z - 1/z_receiver) in tan space, and (z_receiver - z) tan a for the sun (TECHNIQUES 2.11, 2.12).
vec2 lateral_on_ray(LightViewData view, Receiver receiver, vec3 ray, float z) {
  return lateral_of(view, receiver.p_light - ray * ((receiver.p_light.z - z) / ray.z));
}

/// Whether the line from the receiver through a blocker at `lateral`, distance z, goes on to the light; the light is
/// taken wider by what `slack_lateral` at the blocker lets through, because the map places blockers no finer.
bool is_in_light_cone(AreaLight light, LightViewData view, Receiver receiver, vec2 lateral, float z,
                      float slack_lateral) {
  vec3 p = receiver.p_light;
  if (is_orthographic(view)) return length(lateral - p.xy) <= (p.z - z) * light.half_extent.x + slack_lateral;
  vec3 offset = vec3(lateral * z, z) - p;
  float reach = p.z / (p.z - z);
  float slack = slack_lateral * z * reach;
  if (light.type == kSphere) {  // the line's distance from the sphere's centre
    return length(cross(p, offset)) <= (light.half_extent.x + slack) * length(offset);
  }
  vec2 on_light = abs(p.xy + offset.xy * reach);
  if (light.type == kRect) return all(lessThanEqual(on_light, light.half_extent + slack));
  return length(on_light) <= light.half_extent.x + slack;
}
