// SPDX-License-Identifier: Apache-2.0
#include "tests/gpu/technique_fixture.h"

#include "core/error.h"
#include "realtime/realtime.h"
#include "tests/support/procedural_scene.h"
#include "tests/support/source_dir.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <memory>
#include <numbers>

namespace umbrameter::test {
namespace {

constexpr double kLightHeight = 4.0;
constexpr double kEdgeHeight = 1.5;
constexpr double kPlateHeight = 1.0;
const glm::dvec2 kPlateSize(1.0, 0.8);

struct SharedRenderer {
  std::unique_ptr<Renderer> renderer;
  std::string problem;
};

const SharedRenderer& shared_renderer() {
  static const SharedRenderer shared = [] {
    SharedRenderer made;
    const std::filesystem::path realtime = source_dir() / "realtime";
    try {
      made.renderer = make_realtime_renderer({realtime / "techniques", realtime / "shaders", {}});
    } catch (const Error& error) {
      if (error.kind() != ErrorKind::environment) throw;
      made.problem = error.what();
    }
    return made;
  }();
  return shared;
}

/// Length of [a0, a1] inside [b0, b1].
double overlap(double a0, double a1, double b0, double b1) {
  return std::max(0.0, std::min(a1, b1) - std::max(a0, b0));
}

/// Share of a unit disk on the side t > x.
double disk_share_beyond(double x) {
  const double t = std::clamp(x, -1.0, 1.0);
  return (std::acos(t) - t * std::sqrt(1.0 - t * t)) / std::numbers::pi;
}

void look(Scene& scene, const glm::dvec3& eye, const glm::dvec3& at) {
  scene.camera.eye_world = eye;
  scene.camera.at_world = at;
  scene.camera.vertical_fov_deg = 40.0;
}

}  // namespace

std::vector<Technique> techniques() {
  return list_techniques(source_dir() / "realtime" / "techniques");
}

ParameterValues quick(const Technique& technique, int64_t map_size, int64_t light_samples) {
  ParameterValues values;
  for (const Parameter& parameter : technique.parameters) {
    for (const char* size : {"map_size", "face_size", "half_size", "cascade_size"})
      if (parameter.name == size) values[size] = map_size;
    if (parameter.name == "light_samples") values["light_samples"] = light_samples;
  }
  return values;
}

std::string gl_problem() {
  return shared_renderer().problem;
}

Frame render(const Scene& scene, const std::string& technique, const ParameterValues& parameters,
             uint64_t seed, int width_px, int height_px) {
  RenderRequest request;
  request.width_px = width_px;
  request.height_px = height_px;
  request.seed = seed;
  request.technique = technique;
  request.parameters = parameters;
  SilentProgress progress;
  return shared_renderer().renderer->render(scene, request, progress);
}

std::vector<float> visibility(const Scene& scene, const std::string& technique,
                              const ParameterValues& parameters, uint64_t seed) {
  const Frame frame = render(scene, technique, parameters, seed);
  const auto plane = frame.image.plane("visibility");
  return {plane.begin(), plane.end()};
}

Light light_at_4(LightType type, double size) {
  const glm::dvec3 center(0, kLightHeight, 0);
  if (type == LightType::rect) return rect_light_above(center, {size, size});
  if (type == LightType::disk) return disk_light_above(center, 0.5 * size);
  if (type == LightType::sphere) return sphere_light(center, 0.5 * size);
  return sun_light({0, 1, 0}, std::atan(size / 8));
}

LightType any_light(const Technique& technique) {
  return technique.supports(LightType::rect) ? LightType::rect : technique.lights.front();
}

Scene half_plane_scene(const Light& light) {
  Scene scene;
  scene.name = "half-plane";
  add_floor(scene, {12, 12});
  add_floor(scene, {20, 40}, kEdgeHeight, {-10, 0});
  scene.lights = {light};
  look(scene, {2.2, 1.3, 0.7}, {0, 0, 0});
  finish_scene(scene);
  return scene;
}

/// A sphere shows p a disk of radius r / sqrt(1 - (r/d)^2) facing it; the plane through p and the edge cuts
/// that disk along a line.
double half_plane_visibility_of_sphere(const Light& light, const glm::dvec3& p_world) {
  const glm::dvec3 to_center = light.center_world - p_world;
  const double distance = glm::length(to_center);
  const double ratio = light.radius_world / distance;
  const double disk_radius = light.radius_world / std::sqrt(1.0 - ratio * ratio);
  // Normal of the plane through p and the edge {(0, edge height, z)}, towards the open side.
  const glm::dvec3 normal = glm::normalize(glm::dvec3(kEdgeHeight, p_world.x, 0.0));
  const double cos_axis = glm::dot(normal, to_center / distance);
  const double center_offset = glm::dot(normal, to_center) / std::sqrt(1.0 - cos_axis * cos_axis);
  return disk_share_beyond(-center_offset / disk_radius);
}

double half_plane_visibility(const Light& light, const glm::dvec3& p_world) {
  if (light.type == LightType::sphere) return half_plane_visibility_of_sphere(light, p_world);
  if (light.type == LightType::sun) {
    return disk_share_beyond(-p_world.x / (kEdgeHeight * std::tan(light.half_angle_rad)));
  }
  // The ray from (x, 0) through the edge (0, edge height) reaches the light's plane here.
  const double edge_on_light = p_world.x - p_world.x * kLightHeight / kEdgeHeight;
  if (light.type == LightType::rect) {
    return overlap(-0.5 * light.size_world.x, 0.5 * light.size_world.x, edge_on_light, 1e9) /
           light.size_world.x;
  }
  return disk_share_beyond(edge_on_light / light.radius_world);
}

Scene plate_scene() {
  Scene scene;
  scene.name = "plate";
  add_floor(scene, {12, 12});
  add_floor(scene, kPlateSize, kPlateHeight);
  scene.lights = {rect_light_above({0.2, kLightHeight, 0.1}, {1.2, 0.6})};
  look(scene, {2.5, 2.0, 2.0}, {0, 0.2, 0});
  finish_scene(scene);
  return scene;
}

double plate_visibility(const glm::dvec3& p_world) {
  // The plate as seen from p covers a rectangle of the light's plane: p + (corner - p) * light / plate
  // height.
  const double scale = kLightHeight / kPlateHeight;
  const auto shadow = [&](double p, double half_plate, double center, double half_light) {
    return overlap(p + (-half_plate - p) * scale, p + (half_plate - p) * scale, center - half_light,
                   center + half_light) /
           (2 * half_light);
  };
  return 1.0 -
         shadow(p_world.x, 0.5 * kPlateSize.x, 0.2, 0.6) * shadow(p_world.z, 0.5 * kPlateSize.y, 0.1, 0.3);
}

ErrorSummary floor_error(const Frame& frame, const std::function<double(const glm::dvec3&)>& truth) {
  const auto v = frame.image.plane("visibility");
  const auto x = frame.image.plane("position.x");
  const auto y = frame.image.plane("position.y");
  const auto z = frame.image.plane("position.z");
  const auto id = frame.image.plane("primitive_id");
  ErrorSummary summary;
  double sum = 0.0;
  for (size_t i = 0; i < v.size(); ++i) {
    if (id[i] < 0.0f || std::abs(y[i]) > 1e-4f) continue;
    const double error = std::abs(static_cast<double>(v[i]) - truth({x[i], y[i], z[i]}));
    sum += error * error;
    summary.worst = std::max(summary.worst, error);
    ++summary.pixels;
  }
  summary.rmse = std::sqrt(sum / static_cast<double>(summary.pixels));
  return summary;
}

Scene busy_scene(const Light& light) {
  Scene scene;
  scene.name = "busy";
  add_floor(scene, {12, 12});
  add_floor(scene, {0.8, 0.8}, 1.2, {0.2, 0});
  add_floor(scene, {0.5, 1.5}, 2.0, {-0.2, 0.3});
  add_sphere(scene, {0.9, 0.4, -0.5}, 0.4, 12);
  add_quad(scene, {-2, 0, 1}, {-1, 0, 1}, {-1, 1.5, -1}, {-2, 1.5, -1});
  scene.lights = {light};
  scene.camera.eye_world = {2.5, 2.5, 2.5};
  scene.camera.at_world = {-0.2, 0.2, 0};
  finish_scene(scene);
  return scene;
}

ParameterValues with(ParameterValues values, const ParameterValues& more) {
  for (const auto& [name, value] : more) values[name] = value;
  return values;
}

double largest_difference(const std::vector<float>& a, const std::vector<float>& b) {
  double largest = 0.0;
  for (size_t i = 0; i < a.size(); ++i) largest = std::max(largest, std::abs(double{a[i]} - double{b[i]}));
  return largest;
}

double mean_difference(const std::vector<float>& a, const std::vector<float>& b) {
  double sum = 0.0;
  for (size_t i = 0; i < a.size(); ++i) sum += std::abs(double{a[i]} - double{b[i]});
  return sum / static_cast<double>(a.size());
}

}  // namespace umbrameter::test
