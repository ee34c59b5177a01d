// SPDX-License-Identifier: Apache-2.0
#pragma once
// Values as a TOML file has them; what core/toml.h reads back to the last bit.

#include "core/parameters.h"

#include <glm/vec3.hpp>

#include <string>
#include <string_view>

namespace umbrameter {

/// A basic string, quotes around it.
std::string toml_string(std::string_view text);
/// A real, never an integer.
std::string toml_number(double value);
std::string toml_vector(const glm::dvec3& v);
std::string toml_value(const ParameterValue& value);

}  // namespace umbrameter
