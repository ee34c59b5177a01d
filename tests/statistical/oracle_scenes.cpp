// SPDX-License-Identifier: Apache-2.0
#include "tests/statistical/oracle_scenes.h"

#include "tests/statistical/agreement.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace umbrameter {

namespace {

/// Where the ray from floor coordinate `x` through `edge` at the occluder's height meets the light's height.
double on_light(double edge, double x) {
  return (edge - x * (1.0 - kFraction)) / kFraction;
}

double overlap(double low, double high, double half) {
  return std::max(0.0, std::min(high, half) - std::max(low, -half));
}

/// Area common to circles of radii a and b at distance d.
double lens_area(double a, double b, double d) {
  if (d >= a + b) return 0.0;
  const double smaller = std::min(a, b);
  if (d <= std::abs(a - b)) return std::numbers::pi * smaller * smaller;
  const double angle_a = std::acos((d * d + a * a - b * b) / (2.0 * d * a));
  const double angle_b = std::acos((d * d + b * b - a * a) / (2.0 * d * b));
  const double kite = 0.5 * std::sqrt((-d + a + b) * (d + a - b) * (d - a + b) * (d + a + b));
  return a * a * angle_a + b * b * angle_b - kite;
}

/// The textbook corner form: rectangle [0,a] x [0,b] at height y, odd in a and b.
double corner_irradiance(double a, double b, double y) {
  const double ra = std::hypot(a, y);
  const double rb = std::hypot(b, y);
  return 0.5 * (a / ra * std::atan(b / ra) + b / rb * std::atan(a / rb));
}

}  // namespace

Scene floor_under(const Light& light, double seen_width) {
  Scene scene;
  add_floor(scene, {20, 20});
  scene.lights = {light};
  scene.camera = camera_above({0, 0, 0}, seen_width, 0.5 * kOccluderHeight);
  return scene;
}

void add_half_plane(Scene& scene) {
  add_floor(scene, {10, 20}, kOccluderHeight, {-5, 0});
}

double half_plane_square(double x, double size) {
  return std::clamp(0.5 - on_light(0.0, x) / size, 0.0, 1.0);
}

double half_plane_disk(double x, double radius) {
  return disk_share_beyond(-on_light(0.0, x) / radius);
}

double half_plane_sun(double x, double half_angle_rad) {
  return disk_share_beyond(x / (kOccluderHeight * std::tan(half_angle_rad)));
}

double half_plane_sphere(const glm::dvec3& p, double radius) {
  // The plane through p and the edge cuts the cone; on the disk across the cone that is a chord.
  const glm::dvec3 to_center = glm::dvec3(0, kLightHeight, 0) - p;
  const double sin_cone = radius / glm::length(to_center);
  const glm::dvec3 n = glm::normalize(glm::dvec3(kOccluderHeight, p.x, 0));  // away from the sheet
  const double sin_plane = glm::dot(n, glm::normalize(to_center));
  const auto tangent = [](double sine) { return sine / std::sqrt(1.0 - sine * sine); };
  return disk_share_beyond(tangent(sin_plane) / tangent(sin_cone));
}

double plate_rect(const glm::dvec3& p, const glm::dvec2& half, const glm::dvec2& size) {
  const double x = overlap(on_light(-half.x, p.x), on_light(half.x, p.x), 0.5 * size.x);
  const double z = overlap(on_light(-half.y, p.z), on_light(half.y, p.z), 0.5 * size.y);
  return 1.0 - x * z / (size.x * size.y);
}

double coaxial_disks(const glm::dvec3& p, double occluder_radius, double light_radius) {
  const double offset = std::abs(on_light(0.0, std::hypot(p.x, p.z)));
  return 1.0 - lens_area(occluder_radius / kFraction, light_radius, offset) /
                   (std::numbers::pi * light_radius * light_radius);
}

double rectangle_irradiance(double x0, double x1, double z0, double z1, double y) {
  return corner_irradiance(x1, z1, y) - corner_irradiance(x0, z1, y) - corner_irradiance(x1, z0, y) +
         corner_irradiance(x0, z0, y);
}

}  // namespace umbrameter
