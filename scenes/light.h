// SPDX-License-Identifier: Apache-2.0
#pragma once
// The area lights and how they are sampled. Every light has unit radiance; the sun has unit irradiance at
// normal incidence.

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <string>
#include <string_view>

namespace umbrameter {

enum class LightType { rect, disk, sphere, sun };
std::string_view to_text(LightType type);

/// tangent, bitangent, direction are orthonormal; `direction_world` points away from the light into the
/// scene. rect and disk emit to that side only.
struct Light {
  std::string name;
  LightType type = LightType::rect;
  glm::dvec3 center_world{0.0};  // not the sun
  glm::dvec3 tangent_world{1, 0, 0};
  glm::dvec3 bitangent_world{0, 0, 1};
  glm::dvec3 direction_world{0, -1, 0};
  glm::dvec2 size_world{0.0};   // rect: full width along the tangent, full height along the bitangent
  double radius_world = 0.0;    // disk, sphere
  double half_angle_rad = 0.0;  // sun: angular radius
};

/// One sample of a light as seen from a point.
struct LightSample {
  glm::dvec3 to_light_world{0.0};  // unit; zero at or inside the light
  double distance_world = 0.0;     // to the sample; infinity for the sun
  /// Irradiance the receiver would get per unit of visibility if the whole light looked like this sample:
  /// cosine at the receiver x cosine at the light x falloff; 0 behind the receiver or behind the light.
  double irradiance_weight = 0.0;
};

/// The light seen from `p_world` (receiver normal `n_world`) at `uv` in [0,1)^2, uniform in the measure that
/// *geometric visibility* averages over:
///   rect, disk  uniform in the light's area
///   sphere      uniform over the disk through the centre facing `p_world`, scaled so that it spans the cone
///               that the sphere subtends (so a ray hits the sphere from every receiver outside it)
///   sun         uniform in the disk of radius tan(half_angle) around -direction
LightSample sample_light(const Light& light, const glm::dvec3& p_world, const glm::dvec3& n_world,
                         const glm::dvec2& uv);

/// A fixed point of the light (rect, disk; sphere: of the disk facing along direction_world) at `uv`; for the
/// sun the unit direction *towards* the light. What N-map accumulation renders from.
glm::dvec3 light_point(const Light& light, const glm::dvec2& uv);

/// Irradiance at `p_world` (normal `n_world`) with nothing in between: the mean of irradiance_weight over a fixed
/// grid of 8 x 8 points of the light (32 x 32 where it straddles the horizon), so that it carries no noise.
double unshadowed_irradiance(const Light& light, const glm::dvec3& p_world, const glm::dvec3& n_world);

}  // namespace umbrameter
