// SPDX-License-Identifier: Apache-2.0
#pragma once
// Cameras of Mitsuba, and emitters without a shape.

#include "scenes/foreign/foreign_scene.h"
#include "scenes/mitsuba/mitsuba_objects.h"

namespace umbrameter {

/// Adds what is read to `scene`, and counts what is not.
void add_mitsuba_camera(const MitsubaNode& sensor, const MitsubaObjects& objects, ForeignScene& scene);
void add_mitsuba_lamp(const MitsubaNode& emitter, ForeignScene& scene);

/// The emitter's id, else its shape's, else its type.
std::string mitsuba_light_name(const MitsubaNode& emitter, const std::string& shape_id);

}  // namespace umbrameter
