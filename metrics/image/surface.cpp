// SPDX-License-Identifier: Apache-2.0
#include "metrics/image/surface.h"

#include "metrics/image/checks.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace umbrameter {

namespace {

constexpr float kLargest = std::numeric_limits<float>::max();
constexpr std::array kVectorChannels = {"position.x", "position.y", "position.z",
                                        "normal.x",   "normal.y",   "normal.z"};

}  // namespace

// Only what is hit has a position: elsewhere a renderer may leave anything.
SurfaceView checked_surface(const Image& image) {
  const std::vector<uint8_t> everywhere(image.pixel_count(), 1);
  require_range(image, "primitive_id", everywhere, -1.0f, kLargest);
  const std::span<const float> primitive = image.plane("primitive_id");
  std::vector<uint8_t> hit(image.pixel_count());
  for (size_t i = 0; i < hit.size(); ++i) hit[i] = primitive[i] >= 0.0f ? 1 : 0;
  for (const char* channel : kVectorChannels) require_range(image, channel, hit, -kLargest, kLargest);
  return {image.width,
          image.height,
          {image.plane("position.x"), image.plane("position.y"), image.plane("position.z")},
          {image.plane("normal.x"), image.plane("normal.y"), image.plane("normal.z")},
          primitive};
}

bool same_surface(const SurfaceView& surface, size_t i, size_t j) {
  if (!surface.hit(i) || !surface.hit(j)) return false;
  if (surface.primitive[i] == surface.primitive[j]) return true;
  const glm::dvec3 n_i = surface.n_world(i), n_j = surface.n_world(j);
  if (glm::dot(n_i, n_j) < std::sqrt(1.0 - kSurfaceBend * kSurfaceBend)) return false;
  const glm::dvec3 apart = surface.p_world(j) - surface.p_world(i);
  const double limit = kSurfaceBend * glm::length(apart);
  return std::abs(glm::dot(n_i, apart)) <= limit && std::abs(glm::dot(n_j, apart)) <= limit;
}

double pixel_extent_world(const SurfaceView& surface, size_t i) {
  const size_t columns = static_cast<size_t>(surface.width);
  double extent = 0.0;
  if (i % columns > 0 && same_surface(surface, i, i - 1)) {
    extent = glm::length(surface.p_world(i) - surface.p_world(i - 1));
  }
  if (i >= columns && same_surface(surface, i, i - columns)) {
    extent = std::max(extent, glm::length(surface.p_world(i) - surface.p_world(i - columns)));
  }
  return extent;
}

}  // namespace umbrameter
