// SPDX-License-Identifier: Apache-2.0
#pragma once
// Numbers, vectors and transforms of Mitsuba's files. Error{input} at their place for what is not finite or of another length.

#include "core/error.h"

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

#include <string>

namespace umbrameter {

struct MitsubaNode;

double mitsuba_number(const std::string& text, const FileLocation& where);

/// Attributes x, y and z, else `value` with one number for all or three; what is absent is `fallback`.
glm::dvec3 mitsuba_vector(const MitsubaNode& node, double fallback);

/// The <transform> called `name` in `node`: its steps, the first one first. Unit matrix when there is none.
glm::dmat4 mitsuba_transform(const MitsubaNode& node, const std::string& name);

}  // namespace umbrameter
