// SPDX-License-Identifier: Apache-2.0
#pragma once
// Values that cameras, lights and meshes share, read from TOML with their limits. Every function throws
// Error{input} at the key when the value is outside its limits.

#include "core/toml.h"

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <optional>
#include <string>

namespace umbrameter {

/// Limits of lengths and coordinates in scene files, world units.
inline constexpr double kMinLength_world = 1e-9;
inline constexpr double kMaxLength_world = 1e9;

/// A length in [kMinLength_world, kMaxLength_world].
double read_length(TomlReader& reader, const std::string& key);
double read_length(TomlReader& reader, const std::string& key, double fallback);
/// Each component a length.
glm::dvec2 read_lengths2(TomlReader& reader, const std::string& key);
glm::dvec3 read_lengths3(TomlReader& reader, const std::string& key);

/// Each component within +-kMaxLength_world.
glm::dvec3 read_point(TomlReader& reader, const std::string& key);
glm::dvec3 read_point(TomlReader& reader, const std::string& key, const glm::dvec3& fallback);

/// A vector that is not zero, normalised.
glm::dvec3 read_unit_vector(TomlReader& reader, const std::string& key);
glm::dvec3 read_unit_vector(TomlReader& reader, const std::string& key, const glm::dvec3& fallback);

/// A whole number in [min, max]; required when there is no fallback.
int read_count(TomlReader& reader, const std::string& key, int min, int max,
               std::optional<int> fallback = {});

/// (x, y, z) for messages.
std::string to_text(const glm::dvec3& v);

}  // namespace umbrameter
