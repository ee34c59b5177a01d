// SPDX-License-Identifier: Apache-2.0
#include "scenes/rounding.h"

#include <fmt/format.h>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>

namespace umbrameter {

std::optional<std::string> rounding_warning(const Scene& scene) {
  constexpr double kNoticeable = 1e-5;         // of the scene's size
  constexpr double kNoticeableFromEye = 1e-4;  // of the distance to what is looked at
  if (scene.bounds_world.empty()) return std::nullopt;
  const glm::dvec3 reach = glm::max(glm::abs(scene.bounds_world.min), glm::abs(scene.bounds_world.max));
  const double extent = std::max({reach.x, reach.y, reach.z}), diagonal = scene.bounds_world.diagonal();
  const double rounding = extent * 0x1p-24;
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

}  // namespace umbrameter
