// SPDX-License-Identifier: Apache-2.0
#include "lab/truth_oracle.h"

#include <fmt/format.h>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace umbrameter {
namespace {

ReceiverPoint point_of(const Scene& scene, const Image& reference, size_t pixel) {
  const auto width = static_cast<size_t>(reference.width);
  const glm::dvec2 p_px(static_cast<double>(pixel % width) + 0.5, static_cast<double>(pixel / width) + 0.5);
  UMBRAMETER_ASSERT(scene.instanced.empty(), "scene '{}' has instances", scene.name);
  const auto triangle = static_cast<uint32_t>(reference.plane("primitive_id")[pixel]);
  const glm::dvec3 direction =
      camera_ray_direction_world(scene.camera, p_px, reference.width, reference.height);
  const glm::dvec3 corner(scene.positions_world[scene.triangles[triangle].x]);
  glm::dvec3 normal = triangle_normal_world(scene, triangle);
  const double distance = glm::dot(corner - scene.camera.eye_world, normal) / glm::dot(direction, normal);
  if (glm::dot(normal, direction) > 0.0) normal = -normal;
  return {pixel, triangle, scene.camera.eye_world + distance * direction, normal};
}

/// `most` of `pixels`, evenly.
std::vector<size_t> thinned(const std::vector<size_t>& pixels, size_t most) {
  if (pixels.size() <= most) return pixels;
  std::vector<size_t> out;
  for (size_t i = 0; i < most; ++i) out.push_back(pixels[i * pixels.size() / most]);
  return out;
}

std::vector<ReceiverPoint> choose_points(const Scene& scene, const Image& reference,
                                         std::span<const uint8_t> mask, size_t most) {
  const auto visibility = reference.plane("visibility");
  std::vector<size_t> penumbra, rest;
  for (size_t i = 0; i < mask.size(); ++i) {
    if (mask[i] == 0) continue;
    const bool is_partial = visibility[i] > 0.02f && visibility[i] < 0.98f;
    (is_partial ? penumbra : rest).push_back(i);
  }
  std::vector<ReceiverPoint> points;
  const size_t partial = std::min(penumbra.size(), most - most / 4);
  for (const size_t i : thinned(penumbra, partial)) points.push_back(point_of(scene, reference, i));
  for (const size_t i : thinned(rest, most - partial)) points.push_back(point_of(scene, reference, i));
  std::erase_if(points,
                [](const ReceiverPoint& point) { return !std::isfinite(glm::length(point.p_world)); });
  return points;
}

}  // namespace

TruthCheck check_truth(const Scene& scene, const Image& reference, std::span<const uint8_t> mask,
                       const TruthOracle& oracle, size_t most) {
  TruthCheck check;
  const std::vector<ReceiverPoint> points = choose_points(scene, reference, mask, most);
  const auto exact = oracle(scene, points);
  if (!exact) return check;
  const auto visibility = reference.plane("visibility"), se = reference.plane("visibility_se");
  size_t worst_pixel = 0;
  for (size_t i = 0; i < points.size(); ++i) {
    const size_t pixel = points[i].pixel;
    const double error = std::abs(static_cast<double>(visibility[pixel]) - (*exact)[i]);
    ++check.points;
    if (error <= 8.0 * static_cast<double>(se[pixel]) + 1e-3) continue;
    ++check.beyond;
    if (error > check.worst) worst_pixel = pixel;
    check.worst = std::max(check.worst, error);
  }
  if (check.beyond * 32 <= check.points) return check;
  const auto width = static_cast<size_t>(reference.width);
  check.objection =
      fmt::format("{} of {} points miss the exact visibility, by up to {:.3g} at pixel ({}, {})",
                  check.beyond, check.points, check.worst, worst_pixel % width, worst_pixel / width);
  return check;
}

}  // namespace umbrameter
