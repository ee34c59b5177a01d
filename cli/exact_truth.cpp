// SPDX-License-Identifier: Apache-2.0
#include "cli/exact_truth.h"

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

double largest_coordinate(const Scene& scene) {
  const glm::dvec3 most = glm::max(glm::abs(scene.bounds_world.min), glm::abs(scene.bounds_world.max));
  return std::max({most.x, most.y, most.z});
}

std::vector<uint32_t> coplanar_with(const ReceiverPoint& point, const Scene& scene, double slack_world) {
  std::vector<uint32_t> found;
  for (uint32_t t = 0; t < scene.triangles.size(); ++t) {
    const glm::dvec3 normal_world = triangle_normal_world(scene, t);
    const glm::dvec3 corner_world = scene.positions_world[scene.triangles[t].x];
    const double distance = glm::dot(normal_world, point.p_world - corner_world);
    const bool is_parallel = std::abs(glm::dot(normal_world, point.n_world)) > 1.0 - kParallel;
    if (is_parallel && std::abs(distance) <= slack_world) found.push_back(t);
  }
  return found;
}

}  // namespace

TruthOracle exact_truth(const ExactOracle& oracle) {
  return [oracle](const Scene& scene,
                  std::span<const ReceiverPoint> points) -> std::optional<std::vector<double>> {
    if (scene.light().type != LightType::rect || scene.triangles.size() > kMostTriangles) return std::nullopt;
    if (!scene.cutouts.empty() || !scene.instanced.empty()) return std::nullopt;
    const double slack_world = kCoplanar * largest_coordinate(scene);
    const double view_world = glm::distance(scene.camera.eye_world, scene.camera.at_world);
    if (slack_world > kCoarse * std::min(view_world, scene.bounds_world.diagonal())) return std::nullopt;
    std::vector<ExactReceiver> receivers;
    for (const ReceiverPoint& point : points) {
      receivers.push_back(
          {point.p_world, point.n_world, point.n_world, coplanar_with(point, scene, slack_world)});
    }
    SilentProgress silent;
    std::vector<double> exact;
    for (const ExactLight& answer : oracle(scene, receivers, 0, silent)) exact.push_back(answer.visibility());
    return exact;
  };
}

}  // namespace umbrameter
