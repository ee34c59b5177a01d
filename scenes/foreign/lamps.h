// SPDX-License-Identifier: Apache-2.0
#pragma once
// Cameras of other renderers, and their lights that have no size: those follow the rules of glTF's (scenes/imported_scene.h).

#include "scenes/foreign/foreign_scene.h"

namespace umbrameter {

/// Add a light. Directions need not be unit; a light without one is left out and counted.
void add_point_lamp(const std::string& name, const glm::dvec3& center_world, ForeignScene& scene);
void add_spot_lamp(const std::string& name, const glm::dvec3& center_world, const glm::dvec3& direction_world,
                   ForeignScene& scene);
void add_distant_lamp(const std::string& name, const glm::dvec3& direction_world, ForeignScene& scene);

/// A camera of a picture of that size from the space where it stands at the origin and looks along +z with y up; which way x
/// goes does not count. What a matrix does to the picture and we do not is counted. Error{input} at `where` for a matrix that
/// flattens it.
FoundCamera foreign_camera(const std::string& name, const glm::dmat4& world_from_camera, int width_px,
                           int height_px, ForeignScene& scene, const FileLocation& where);

}  // namespace umbrameter
