// SPDX-License-Identifier: Apache-2.0
#include "scenes/mitsuba/mitsuba_views.h"

#include "scenes/foreign/lamps.h"
#include "scenes/mitsuba/mitsuba_numbers.h"

#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>
#include <glm/trigonometric.hpp>

#include <cmath>

namespace umbrameter {
namespace {

using glm::dvec3;

constexpr int kFilmWidth_px = 768, kFilmHeight_px = 576;  // of a film that does not say
constexpr int kMaxFilm_px = 1 << 20;
const double kFilmDiagonal_mm = std::hypot(36.0, 24.0);  // of the film that focal lengths are for
constexpr double kFocalLength_mm = 50.0;

int film_pixels(const MitsubaNode& film, const std::string& name, int fallback) {
  const double value = film.number(name, fallback);
  if (value >= 1.0 && value <= kMaxFilm_px) return static_cast<int>(value);
  fail_input(fmt::format("the film's '{}' is {}", name, value), film.where);
}

/// Tangent of half the angle along `axis`, and that axis.
double half_tangent(const MitsubaNode& sensor, std::string& axis) {
  if (sensor.find("fov") != nullptr) {
    const double fov_deg = sensor.number("fov", 0.0);
    if (fov_deg > 0.0 && fov_deg < 180.0) return std::tan(glm::radians(0.5 * fov_deg));
    fail_input(fmt::format("'fov' = {} must lie between 0 and 180 degrees", fov_deg), sensor.where);
  }
  axis = "diagonal";
  std::string length = sensor.text("focal_length", fmt::format("{}mm", kFocalLength_mm));
  if (length.ends_with("mm")) length.resize(length.size() - 2);
  const double length_mm = mitsuba_number(length, sensor.where);
  if (length_mm > 0.0) return 0.5 * kFilmDiagonal_mm / length_mm;
  fail_input(fmt::format("'focal_length' = {} must be above 0", length_mm), sensor.where);
}

double vertical_fov_deg(const MitsubaNode& sensor, double aspect) {
  std::string axis = sensor.text("fov_axis", "x");
  const double tangent = half_tangent(sensor, axis);
  if (axis == "smaller") axis = aspect > 1.0 ? "y" : "x";
  if (axis == "larger") axis = aspect > 1.0 ? "x" : "y";
  const auto degrees = [](double half) { return 2.0 * glm::degrees(std::atan(half)); };
  if (axis == "y") return degrees(tangent);
  if (axis == "x") return degrees(tangent / aspect);
  if (axis == "diagonal") return degrees(tangent / std::hypot(aspect, 1.0));
  fail_input(fmt::format("'fov_axis' is '{}'", axis), sensor.where,
             "x, y, diagonal, smaller and larger are known");
}

}  // namespace

void add_mitsuba_camera(const MitsubaNode& sensor, const MitsubaObjects& objects, ForeignScene& scene) {
  const std::string& type = sensor.get("type");
  if (type != "perspective" && type != "thinlens") {
    scene.of_views.leave_out("camera", type);
    return;
  }
  if (type == "thinlens")
    scene.of_views.add("camera with a lens is a pinhole camera", "cameras with a lens are pinhole cameras");
  const std::string name = fmt::format("sensor '{}'", sensor.get("id").empty() ? type : sensor.get("id"));
  const glm::dmat4 world_from_camera = mitsuba_transform(sensor, "to_world");
  if (glm::determinant(glm::dmat3(world_from_camera)) < 0.0)
    scene.of_views.add("camera mirrors its picture; here it does not",
                       "cameras mirror their pictures; here they do not");
  const auto films = objects.nested(sensor, "film");
  const MitsubaNode none;
  const MitsubaNode& film = films.empty() ? none : *films.front();
  const int width_px = film_pixels(film, "width", kFilmWidth_px);
  const int height_px = film_pixels(film, "height", kFilmHeight_px);
  FoundCamera camera = foreign_camera(name, world_from_camera, width_px, height_px, scene, sensor.where);
  if (film.find("crop_width") != nullptr || film.find("crop_height") != nullptr)
    scene.of_views.add("crop of a film is not carried over", "crops of films are not carried over");
  if (sensor.number("principal_point_offset_x", 0.0) != 0.0 ||
      sensor.number("principal_point_offset_y", 0.0) != 0.0)
    scene.of_views.add("shift of a camera is not carried over", "shifts of cameras are not carried over");
  camera.vertical_fov_deg = vertical_fov_deg(sensor, static_cast<double>(width_px) / height_px);
  camera.near_world = sensor.number("near_clip", 0.0);
  if (camera.near_world < 0.0)
    fail_input(fmt::format("'near_clip' = {} must not be below 0", camera.near_world), sensor.where);
  scene.cameras.push_back(std::move(camera));
}

void add_mitsuba_lamp(const MitsubaNode& emitter, ForeignScene& scene) {
  const std::string& type = emitter.get("type");
  const std::string name = mitsuba_light_name(emitter, {});
  const glm::dmat4 world = mitsuba_transform(emitter, "to_world");
  if (type == "point") {
    const MitsubaNode* position = emitter.find("position");
    add_point_lamp(name, position != nullptr ? mitsuba_vector(*position, 0.0) : dvec3(world[3]), scene);
  } else if (type == "spot") {
    add_spot_lamp(name, dvec3(world[3]), dvec3(world[2]), scene);
  } else if (type == "directional") {
    const MitsubaNode* direction = emitter.find("direction");
    add_distant_lamp(name, direction != nullptr ? mitsuba_vector(*direction, 0.0) : dvec3(world[2]), scene);
  } else {
    scene.of_views.leave_out("emitter", type);
  }
}

std::string mitsuba_light_name(const MitsubaNode& emitter, const std::string& shape_id) {
  if (!emitter.get("id").empty()) return emitter.get("id");
  return !shape_id.empty() ? shape_id : emitter.get("type");
}

}  // namespace umbrameter
