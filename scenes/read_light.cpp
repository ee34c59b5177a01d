// SPDX-License-Identifier: Apache-2.0
#include "scenes/read_light.h"

#include "scenes/read_values.h"

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include <array>

namespace umbrameter {
namespace {

using glm::dvec3;

const std::array<std::string, 4> kTypes = {"rect", "disk", "sphere", "sun"};
constexpr double kMinTangentSine = 1e-6;  // of the angle between tangent and direction
constexpr double kVerticalSine = 1e-3;

const dvec3 kDown(0, -1, 0);

dvec3 read_direction(TomlReader& reader, const Light& light) {
  const bool has_at = reader.has("at");
  // A sphere shines to all sides: where a map of it looks is all that this decides.
  if (light.type == LightType::sphere && !has_at && !reader.has("direction")) return kDown;
  if (has_at == reader.has("direction")) {
    reader.fail("direction",
                has_at ? "give either 'direction' or 'at', not both" : "'direction' or 'at' is missing",
                "'direction' points away from the light, 'at' is the point it faces");
  }
  if (!has_at) return read_unit_vector(reader, "direction");
  if (light.type == LightType::sun) reader.fail("at", "a sun has no place, so no 'at'", "use 'direction'");
  const dvec3 at = read_point(reader, "at");
  const double distance = glm::length(at - light.center_world);
  if (distance < kMinLength_world)
    reader.fail("at", fmt::format("'at' = {} is the light's centre", to_text(at)));
  return (at - light.center_world) / distance;
}

dvec3 read_tangent(TomlReader& reader, const dvec3& direction) {
  if (!reader.has("tangent")) return default_tangent(direction);
  const dvec3 wanted = read_unit_vector(reader, "tangent");
  const dvec3 tangent = wanted - direction * glm::dot(wanted, direction);
  if (glm::length(tangent) > kMinTangentSine) return glm::normalize(tangent);
  reader.fail("tangent", fmt::format("'tangent' = {} is parallel to the light's direction", to_text(wanted)));
}

double read_half_angle_rad(TomlReader& reader) {
  const double diameter_deg = reader.number("angular_diameter_deg");
  if (diameter_deg >= 1e-6 && diameter_deg <= 90.0) return glm::radians(diameter_deg) / 2;
  reader.fail("angular_diameter_deg",
              fmt::format("'angular_diameter_deg' = {} must lie between 1e-6 and 90 degrees", diameter_deg),
              "the real sun has 0.53");
}

}  // namespace

dvec3 default_tangent(const dvec3& direction_world) {
  const dvec3 horizontal = glm::cross(direction_world, dvec3(0, 1, 0));
  return glm::normalize(glm::length(horizontal) > kVerticalSine
                            ? horizontal
                            : dvec3(1, 0, 0) - direction_world * direction_world.x);
}

Light read_light(const TomlNode& table) {
  TomlReader reader(table, "[[light]]");
  Light light;
  light.type = static_cast<LightType>(reader.choice("type", kTypes));
  light.name = reader.text("name", "");
  if (light.name.empty() && reader.has("name")) reader.fail("name", "the light's 'name' is empty");
  if (light.type != LightType::sun) light.center_world = read_point(reader, "center");
  if (light.type == LightType::rect) light.size_world = read_lengths2(reader, "size");
  if (light.type == LightType::disk || light.type == LightType::sphere) {
    light.radius_world = read_length(reader, "radius");
  }
  if (light.type == LightType::sun) light.half_angle_rad = read_half_angle_rad(reader);
  light.direction_world = read_direction(reader, light);
  light.tangent_world = read_tangent(reader, light.direction_world);
  light.bitangent_world = glm::cross(light.direction_world, light.tangent_world);
  reader.finish();
  return light;
}

}  // namespace umbrameter
