// SPDX-License-Identifier: Apache-2.0
#include "scenes/read_values.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace umbrameter {
namespace {

void require_length(const TomlReader& reader, const std::string& key, double value) {
  if (value >= kMinLength_world && value <= kMaxLength_world) return;
  reader.fail(key, fmt::format("'{}' = {} must be a length above 0", key, value),
              fmt::format("at least {:g}, at most {:g}", kMinLength_world, kMaxLength_world));
}

}  // namespace

double read_length(TomlReader& reader, const std::string& key) {
  const double value = reader.number(key);
  require_length(reader, key, value);
  return value;
}

double read_length(TomlReader& reader, const std::string& key, double fallback) {
  return reader.has(key) ? read_length(reader, key) : fallback;
}

glm::dvec2 read_lengths2(TomlReader& reader, const std::string& key) {
  const glm::dvec2 value = reader.vec2(key);
  for (int i = 0; i < 2; ++i) require_length(reader, key, value[i]);
  return value;
}

glm::dvec3 read_lengths3(TomlReader& reader, const std::string& key) {
  const glm::dvec3 value = reader.vec3(key);
  for (int i = 0; i < 3; ++i) require_length(reader, key, value[i]);
  return value;
}

glm::dvec3 read_point(TomlReader& reader, const std::string& key) {
  const glm::dvec3 value = reader.vec3(key);
  for (int i = 0; i < 3; ++i) {
    if (std::abs(value[i]) <= kMaxLength_world) continue;
    reader.fail(key, fmt::format("'{}' holds {}; coordinates must stay within {:g}", key, value[i],
                                 kMaxLength_world));
  }
  return value;
}

glm::dvec3 read_point(TomlReader& reader, const std::string& key, const glm::dvec3& fallback) {
  return reader.has(key) ? read_point(reader, key) : fallback;
}

glm::dvec3 read_unit_vector(TomlReader& reader, const std::string& key) {
  glm::dvec3 value = reader.vec3(key);
  const double largest = std::max({std::abs(value.x), std::abs(value.y), std::abs(value.z)});
  if (largest == 0.0) reader.fail(key, fmt::format("'{}' = {} has no direction", key, to_text(value)));
  return glm::normalize(value / largest);
}

glm::dvec3 read_unit_vector(TomlReader& reader, const std::string& key, const glm::dvec3& fallback) {
  return reader.has(key) ? read_unit_vector(reader, key) : fallback;
}

int read_count(TomlReader& reader, const std::string& key, int min, int max, std::optional<int> fallback) {
  const int64_t value = fallback ? reader.integer(key, *fallback) : reader.integer(key);
  if (value >= min && value <= max) return static_cast<int>(value);
  reader.fail(key, fmt::format("'{}' = {} must be between {} and {}", key, value, min, max));
}

std::string to_text(const glm::dvec3& v) {
  return fmt::format("({}, {}, {})", v.x, v.y, v.z);
}

}  // namespace umbrameter
