// SPDX-License-Identifier: Apache-2.0
#pragma once
// Slices of the camera's frustum. Internal to views/.

#include "realtime/views/light_view.h"

#include <array>

namespace umbrameter {

/// The eight corners of a slice: four at its near distance, four at its far one.
std::array<glm::dvec3, 8> corners_world(const Camera& camera, const glm::ivec2& screen_px,
                                        const CameraSlice& slice);

struct Sphere {
  glm::dvec3 center_world{0.0};
  double radius_world = 0.0;
};

/// The smallest sphere around a slice: its middle lies on the camera's axis, its radius does not depend on where the
/// camera looks.
Sphere sphere_around(const Camera& camera, const glm::ivec2& screen_px, const CameraSlice& slice);

}  // namespace umbrameter
