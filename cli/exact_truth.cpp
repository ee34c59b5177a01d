// SPDX-License-Identifier: Apache-2.0
#include "cli/exact_truth.h"

#include "reference/exact/exact_visibility.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace umbrameter {
namespace {

constexpr size_t kMostTriangles = 300;  // seconds a picture
constexpr double kCoplanar = 0x1p-22;   // of the largest coordinate: two roundings of a float
constexpr double kCoarse = 1e-2;        // of the scene and the view: roundings as large as parts
constexpr double kParallel = 1e-6;      // 1 - cosine

struct ExactTriangle {
  TriangleCorners corners;
  glm::dvec3 normal_world;
};

std::vector<ExactTriangle> triangles_of(const Scene& scene) {
  std::vector<ExactTriangle> all;
  for (uint32_t t = 0; t < scene.triangles.size(); ++t) {
    const glm::uvec3& at = scene.triangles[t];
    all.push_back({{scene.positions_world[at.x], scene.positions_world[at.y], scene.positions_world[at.z]},
                   triangle_normal_world(scene, t)});
  }
  return all;
}

double largest_coordinate(const Scene& scene) {
  const glm::dvec3 most = glm::max(glm::abs(scene.bounds_world.min), glm::abs(scene.bounds_world.max));
  return std::max({most.x, most.y, most.z});
}

std::vector<TriangleCorners> blockers_of(const std::vector<ExactTriangle>& triangles,
                                         const ReceiverPoint& point, double slack_world) {
  std::vector<TriangleCorners> out;
  for (const ExactTriangle& triangle : triangles) {
    const double distance = glm::dot(triangle.normal_world, point.p_world - triangle.corners[0]);
    const bool is_parallel = std::abs(glm::dot(triangle.normal_world, point.n_world)) > 1.0 - kParallel;
    if (!is_parallel || std::abs(distance) > slack_world) out.push_back(triangle.corners);
  }
  return out;
}

}  // namespace

TruthOracle exact_oracle() {
  return [](const Scene& scene, std::span<const ReceiverPoint> points) -> std::optional<std::vector<double>> {
    const Light& light = scene.light();
    if (light.type != LightType::rect || scene.triangles.size() > kMostTriangles) return std::nullopt;
    if (!scene.cutouts.empty()) return std::nullopt;
    const PolygonLight polygon =
        rectangle_light(light.center_world, light.tangent_world, light.bitangent_world, light.direction_world,
                        light.size_world);
    const std::vector<ExactTriangle> triangles = triangles_of(scene);
    const double slack_world = kCoplanar * largest_coordinate(scene);
    const double view_world = glm::distance(scene.camera.eye_world, scene.camera.at_world);
    if (slack_world > kCoarse * std::min(view_world, scene.bounds_world.diagonal())) return std::nullopt;
    std::vector<double> exact;
    for (const ReceiverPoint& point : points) {
      exact.push_back(exact_visibility(blockers_of(triangles, point, slack_world), point.p_world,
                                       point.n_world, polygon));
    }
    return exact;
  };
}

}  // namespace umbrameter
