// SPDX-License-Identifier: Apache-2.0
#pragma once
// What the exact oracle is asked and what it answers. The oracle itself is a program of its own (reference/exact/): it links
// CGAL's arrangements, which are GPL, and nothing else does.

#include "core/progress.h"
#include "scenes/scene.h"

#include <functional>
#include <optional>
#include <span>
#include <vector>

namespace umbrameter {

/// A point of a surface; the normals face the side it is seen from.
struct ExactReceiver {
  glm::dvec3 p_world{0.0};
  glm::dvec3 n_geometric_world{0.0};
  glm::dvec3 n_shading_world{0.0};
  std::vector<uint32_t> transparent{};  // triangles that hide nothing from here; ascending
};

struct ExactLight {
  /// Geometric visibility (docs/conventions.md) lies between these: equal but for rounding under a rectangle, at most 8e-5
  /// apart under round lights.
  double visibility_low = 0.0;
  double visibility_high = 0.0;
  /// Of the visible part of the light, over that of all of it; the closed form for polygons (Lambert). Rectangle and disk.
  std::optional<double> irradiance_ratio{};
  size_t triangles = 0;  // between the receiver and the light
  size_t edges = 0;      // that bound their shadow
  double visibility() const { return 0.5 * (visibility_low + visibility_high); }
};

/// The active light as each receiver sees it, with at most `threads` threads (0 = all).
using ExactOracle = std::function<std::vector<ExactLight>(
    const Scene& scene, std::span<const ExactReceiver> receivers, int threads, Progress& progress)>;

}  // namespace umbrameter
