// SPDX-License-Identifier: Apache-2.0
#include "reference/tile_proof.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <vector>

namespace umbrameter {

namespace {

/// What lies beyond n . p > limit cannot meet the hull.
struct Side {
  glm::dvec3 n;
  double limit = 0.0;
};

double highest(const Bounds3& box, const glm::dvec3& n) {
  const glm::dvec3 a = n * box.min, b = n * box.max;
  return std::max(a.x, b.x) + std::max(a.y, b.y) + std::max(a.z, b.z);
}

void add_point(Bounds3& box, const glm::dvec3& p) {
  box.min = glm::min(box.min, p);
  box.max = glm::max(box.max, p);
}

/// The hull of a box around all ray origins and one around the ends of their shafts, as its sides (Haines and Wallace,
/// "Shaft culling for efficient ray-traced radiosity", 1991), and the surface that the pixels share.
class TileShaft {
 public:
  TileShaft(double scene_extent_world, std::span<const ShaftPixel> pixels)
      : margin_(static_cast<double>(kShaftRoundoffs) * scene_extent_world),
        surface_(pixels.front().n_geometric_world) {
    double lowest_origin = std::numeric_limits<double>::infinity();
    for (const ShaftPixel& pixel : pixels) add(pixel, scene_extent_world, lowest_origin);
    set_sides();
    // Without a margin: origins are raised over their surface for good.
    sides_.push_back({-surface_, std::max(-lowest_origin, highest(ends_, -surface_))});
  }

  bool is_possible() const { return is_possible_; }

  bool meets(const OccluderBox& box) const {
    const Bounds3 bounds{{box.min[0], box.min[1], box.min[2]}, {box.max[0], box.max[1], box.max[2]}};
    return std::ranges::none_of(sides_,
                                [&](const Side& side) { return -highest(bounds, -side.n) > side.limit; });
  }

  bool meets(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) const {
    for (const Side& side : sides_) {
      if (std::min({glm::dot(side.n, a), glm::dot(side.n, b), glm::dot(side.n, c)}) > side.limit)
        return false;
    }
    const glm::dvec3 n = glm::cross(b - a, c - a);
    const double height = glm::dot(n, a), margin = margin_ * glm::length(n);
    return height <= support(n) + margin && -height <= support(-n) + margin;
  }

 private:
  void add(const ShaftPixel& pixel, double scene_extent_world, double& lowest_origin) {
    const PatchCorners corners = corners_of(pixel.patch);
    is_possible_ = is_possible_ && only_occluders_matter(pixel.patch, corners);
    const float end = shaft_end(pixel.patch, scene_extent_world);
    const glm::dvec3 origin(pixel.ray_origin_world);
    add_point(origins_, origin);
    for (const glm::vec3& way : corners.ways_world) add_point(ends_, origin + glm::dvec3(end * way));
    lowest_origin = std::min(lowest_origin, glm::dot(surface_, origin));
  }

  double support(const glm::dvec3& n) const { return std::max(highest(origins_, n), highest(ends_, n)); }

  void add_side(const glm::dvec3& n) { sides_.push_back({n, support(n) + margin_ * glm::length(n)}); }

  void set_sides() {
    for (int axis = 0; axis < 3; ++axis) {
      for (const double sign : {-1.0, 1.0}) {
        glm::dvec3 n(0.0);
        n[axis] = sign;
        add_side(n);
      }
      add_slanted_sides(axis, (axis + 1) % 3);
    }
  }

  /// Along the third axis, through the edges of both boxes that lie alike.
  void add_slanted_sides(int u, int v) {
    for (const bool high_u : {false, true}) {
      for (const bool high_v : {false, true}) {
        const double along_u = high_u ? ends_.max[u] - origins_.max[u] : ends_.min[u] - origins_.min[u];
        const double along_v = high_v ? ends_.max[v] - origins_.max[v] : ends_.min[v] - origins_.min[v];
        glm::dvec3 n(0.0);
        n[u] = along_v;
        n[v] = -along_u;
        const bool is_outwards = (high_u ? n[u] : -n[u]) + (high_v ? n[v] : -n[v]) > 0.0;
        add_side(is_outwards ? n : -n);
      }
    }
  }

  double margin_;
  glm::dvec3 surface_;
  Bounds3 origins_;
  Bounds3 ends_;
  bool is_possible_ = true;
  std::vector<Side> sides_;
};

bool meets_any(const TileShaft& shaft, const OccluderTree& tree, const Scene& scene,
               const OccluderLeaf& leaf) {
  const auto corner = [&](uint32_t vertex) { return glm::dvec3(scene.positions_world[vertex]); };
  return std::any_of(leaf.triangles.begin(), leaf.triangles.begin() + leaf.triangle_count,
                     [&](uint32_t triangle) {
                       if (const OccluderBox* box = tree.instance_box(triangle)) return shaft.meets(*box);
                       const glm::uvec3 index = scene.triangles[triangle];
                       return shaft.meets(corner(index.x), corner(index.y), corner(index.z));
                     });
}

bool meets_any(const TileShaft& shaft, const OccluderTree& tree, const Scene& scene,
               const OccluderNode* node) {
  if (node->triangle_count > 0) return meets_any(shaft, tree, scene, *static_cast<const OccluderLeaf*>(node));
  const auto& inner = *static_cast<const OccluderInner*>(node);
  for (uint32_t k = 0; k < inner.child_count; ++k) {
    if (shaft.meets(inner.boxes[k]) && meets_any(shaft, tree, scene, inner.children[k])) return true;
  }
  return false;
}

}  // namespace

bool proves_all_lit(const OccluderTree& tree, const Scene& scene, double scene_extent_world,
                    std::span<const ShaftPixel> pixels) {
  if (pixels.empty()) return true;
  const TileShaft shaft(scene_extent_world, pixels);
  if (!shaft.is_possible()) return false;
  return tree.root() == nullptr || !meets_any(shaft, tree, scene, tree.root());
}

}  // namespace umbrameter
