// SPDX-License-Identifier: Apache-2.0
#include "scenes/rounding.h"

#include <fmt/format.h>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include <algorithm>
#include <cmath>

namespace umbrameter {
namespace {

constexpr double kFloatRounding = 0x1p-24;  // of a number's size

double reach(const glm::dvec3& p_world) {
  const glm::dvec3 sizes = glm::abs(p_world);
  return std::max({sizes.x, sizes.y, sizes.z});
}

/// Farthest coordinate from the origin.
double reach(const Bounds3& bounds) {
  return std::max(reach(bounds.min), reach(bounds.max));
}

/// 0: a point or a direction, whose parts nobody asks for.
double narrowest_width_world(const Light& light, double diagonal_world) {
  switch (light.type) {
    case LightType::rect:
      return std::min(light.size_world.x, light.size_world.y);
    case LightType::disk:
    case LightType::sphere:
      return 2.0 * light.radius_world;
    case LightType::sun:
      return 2.0 * std::tan(light.half_angle_rad) * diagonal_world;
  }
  return 0.0;
}

}  // namespace

std::optional<std::string> rounding_warning(const Scene& scene) {
  constexpr double kNoticeable = 1e-5;         // of the scene's size
  constexpr double kNoticeableFromEye = 1e-4;  // of the distance to what is looked at
  if (scene.bounds_world.empty()) return std::nullopt;
  const double extent = reach(scene.bounds_world), diagonal = scene.bounds_world.diagonal();
  const double rounding = extent * kFloatRounding;
  const double view = glm::distance(scene.camera.eye_world, scene.camera.at_world);
  if (rounding <= kNoticeable * diagonal && rounding > kNoticeableFromEye * view)
    return fmt::format(
        "positions are rounded by up to {:.2g} at the rim of the scene, {:.3g} away, and the camera looks at "
        "what is {:.3g} "
        "away: rays cannot tell what lies closer together",
        rounding, extent, view);
  if (rounding <= kNoticeable * diagonal) return std::nullopt;
  return fmt::format(
      "positions are rounded by up to {:.2g}: the scene is {:.3g} wide and lies up to {:.3g} from the origin",
      rounding, diagonal, extent);
}

std::vector<std::string> narrow_light_warnings(const Scene& scene) {
  constexpr double kFinest = 1.0 / 256.0;  // of the light, what a step of a picture of eight bits shows
  std::vector<std::string> warnings;
  if (scene.bounds_world.empty()) return warnings;
  for (const Light& light : scene.lights) {
    const double width = narrowest_width_world(light, scene.bounds_world.diagonal());
    const double rounding = std::max(reach(scene.bounds_world), reach(light.center_world)) * kFloatRounding;
    if (width <= 0.0 || rounding <= kFinest * width) continue;
    warnings.push_back(
        fmt::format("light '{}' is {:.2g} wide and positions are rounded by up to {:.2g}: its penumbrae are "
                    "true to about {:.2g} of it",
                    light.name, width, rounding, std::min(1.0, rounding / width)));
  }
  return warnings;
}

}  // namespace umbrameter
