// SPDX-License-Identifier: Apache-2.0
#include "scenes/pbrt/pbrt_camera.h"

#include "scenes/foreign/lamps.h"

#include <glm/trigonometric.hpp>

#include <cmath>

namespace umbrameter {
namespace {

constexpr double kPbrtFilmWidth = 1280.0, kPbrtFilmHeight = 720.0;
constexpr double kMostPbrtPixels = 1e6;  // along a side

/// In units of the tangent of half of 'fov', which is that of the shorter side.
double screen_half_height(const PbrtParameters& camera, double film_aspect, ForeignScene& scene) {
  const double aspect = camera.number("frameaspectratio", film_aspect);
  if (!(aspect > 0.0))
    fail_input(fmt::format("'frameaspectratio' = {} must be above 0", aspect), camera.where());
  const PbrtParameter* window = camera.find("screenwindow");
  if (window == nullptr) return aspect > 1.0 ? 1.0 : 1.0 / aspect;
  const std::vector<double>& n = window->numbers;
  if (n.size() != 4 || !(n[1] > n[0] && n[3] > n[2]))
    fail_input("'screenwindow' is not [left, right, bottom, top]", window->where);
  if (n[0] != -n[1] || n[2] != -n[3])
    scene.of_views.add("shift of a camera is not carried over", "shifts of cameras are not carried over");
  return 0.5 * (n[3] - n[2]);
}

}  // namespace

void add_pbrt_camera(const PbrtParameters& camera, const glm::dmat4& world_from_camera,
                     const std::optional<PbrtParameters>& film, ForeignScene& scene) {
  const double width_px = film ? film->number("xresolution", kPbrtFilmWidth) : kPbrtFilmWidth;
  const double height_px = film ? film->number("yresolution", kPbrtFilmHeight) : kPbrtFilmHeight;
  if (!(width_px >= 1.0 && height_px >= 1.0 && width_px <= kMostPbrtPixels && height_px <= kMostPbrtPixels))
    fail_input(fmt::format("the film has {} x {} pixels", width_px, height_px), film->where());
  FoundCamera found = foreign_camera("the file", world_from_camera, static_cast<int>(width_px),
                                     static_cast<int>(height_px), scene, camera.where());
  if (film && (film->find("cropwindow") != nullptr || film->find("pixelbounds") != nullptr))
    scene.of_views.add("crop of a film is not carried over", "crops of films are not carried over");
  if (camera.number("lensradius", 0.0) > 0.0)
    scene.of_views.add("camera with a lens is a pinhole camera", "cameras with a lens are pinhole cameras");
  const double fov_deg = camera.number("fov", 90.0);
  if (!(fov_deg > 0.0 && fov_deg < 180.0))
    fail_input(fmt::format("'fov' = {} must lie between 0 and 180 degrees", fov_deg), camera.where());
  const double half_height = screen_half_height(camera, width_px / height_px, scene);
  found.vertical_fov_deg = 2.0 * glm::degrees(std::atan(half_height * std::tan(glm::radians(0.5 * fov_deg))));
  scene.cameras.push_back(std::move(found));
}

}  // namespace umbrameter
