// SPDX-License-Identifier: Apache-2.0
#include "reference/light_proof.h"

#include "reference/light_shafts.h"

#include <glm/geometric.hpp>

#include <limits>

namespace umbrameter {

namespace {

float least(const PatchForm& form) {
  return form.center - std::abs(form.per_a) - std::abs(form.per_b);
}

/// The rays rise from the receiver's plane by more than rounding can bend it.
bool is_above_horizon(const LightPatch& patch, float length) {
  constexpr float kLeastSlope = 1e-4f;
  return least(patch.above_surface) > kLeastSlope * length;
}

bool has_plain_cosine(const LightPatch& patch) {
  return is_unlit(patch) || least(patch.shading) > 0.0f;
}

void set_lane(LaneVector& lanes, uint32_t i, const glm::vec3& v) {
  lanes.x[i] = v.x;
  lanes.y[i] = v.y;
  lanes.z[i] = v.z;
}

void set_plane(LanePlanes& plane, uint32_t i, const glm::vec3& n, float margin) {
  set_lane(plane.n, i, n);
  plane.margin[i] = margin;
}

/// Adds a pixel's shaft; says whether nothing but an occluder can keep it from being fully lit.
bool add_shaft(LightShafts& shafts, uint32_t i, const ShaftPixel& pixel) {
  const LightPatch& patch = pixel.patch;
  const float end = shaft_end(patch, static_cast<double>(shafts.extent));
  const float margin = kShaftRoundoffs * shafts.extent;
  const glm::vec3 center{patch.direction_x.center, patch.direction_y.center, patch.direction_z.center};
  const PatchCorners corners = corners_of(patch);
  const auto& ways = corners.ways_world;
  for (size_t k = 0; k < 4; ++k) set_lane(shafts.corners[k], i, end * ways[k]);
  set_lane(shafts.origin, i, pixel.ray_origin_world);
  shafts.corner_length[i] = end * corners.greatest_length;
  // The sphere's point nearest to the origin lies before those that other rays end at.
  shafts.cover_fraction[i] = std::max(0.0f, 1.0f - patch.sphere_radius_world / glm::length(center));
  bool is_wide = true;
  for (size_t k = 0; k < 4; ++k) {
    const glm::vec3 n = glm::cross(ways[k], ways[(k + 1) % 4]);
    const float size = glm::length(n);
    is_wide = is_wide && size > 0.0f;
    const float inwards = glm::dot(n, center) < 0.0f ? -1.0f : 1.0f;
    set_plane(shafts.planes[k], i, n * (inwards / size), margin);
  }
  glm::vec3 axis = glm::normalize(glm::cross(ways[1] - ways[0], ways[3] - ways[0]));
  if (glm::dot(axis, center) < 0.0f) axis = -axis;
  set_plane(shafts.planes[4], i, -axis, end * glm::dot(axis, center));
  set_plane(shafts.planes[5], i, pixel.n_geometric_world, 0.0f);
  return is_wide && only_occluders_matter(patch, corners);
}

struct Walk {
  const OccluderTree& tree;
  const glm::uvec3* triangles_of_scene;
  const glm::vec3* positions;
  const LightShafts& shafts;
  uint32_t first_cutout;
  LaneMask used{};     // lanes that hold a pixel
  LaneMask lit{};      // may still be lit
  LaneMask covered{};  // proven dark
  uint32_t triangles = 0;
};

UMBRAMETER_LANES void meet_leaf(Walk& walk, const OccluderLeaf& leaf) {
  for (uint32_t k = 0; k < leaf.triangle_count; ++k) {
    if (const OccluderBox* box = walk.tree.instance_box(leaf.triangles[k])) {
      const LaneMask meets = meets_box(walk.shafts, *box);
      for (uint32_t i = 0; i < kShafts; ++i) walk.lit[i] &= ~meets[i];
      continue;
    }
    const glm::uvec3 index = walk.triangles_of_scene[leaf.triangles[k]];
    const glm::vec3* positions = walk.positions;
    const LaneTriangle triangle =
        see_triangle(walk.shafts, positions[index.x], positions[index.y], positions[index.z]);
    const TriangleVerdict verdict = judge(walk.shafts, triangle);
    const int32_t is_solid = leaf.triangles[k] < walk.first_cutout ? -1 : 0;  // holes may let light through
    for (uint32_t i = 0; i < kShafts; ++i) {
      walk.lit[i] &= ~verdict.meets[i];
      walk.covered[i] |= walk.used[i] & verdict.covers[i] & is_solid;
    }
  }
  walk.triangles += leaf.triangle_count;
}

/// Lanes that are worth going on for: those without an occluder so far and, for a while, those not yet covered.
UMBRAMETER_LANES LaneMask undecided(const Walk& walk) {
  constexpr uint32_t kPatience = 48;  // triangles; a cover is big, fine meshes have none
  const int32_t hunting = walk.triangles < kPatience ? -1 : 0;
  LaneMask mask;
  for (uint32_t i = 0; i < kShafts; ++i) mask[i] = walk.lit[i] | (walk.used[i] & ~walk.covered[i] & hunting);
  return mask;
}

UMBRAMETER_LANES bool meets_any(const Walk& walk, const OccluderBox& box, const LaneMask& lanes) {
  const LaneMask meets = meets_box(walk.shafts, box);
  int32_t any = 0;
  for (uint32_t i = 0; i < kShafts; ++i) any |= meets[i] & lanes[i];
  return any != 0;
}

UMBRAMETER_WIDE
void walk_tree(const OccluderNode* root, Walk& walk) {
  constexpr size_t kStack = 256;  // the builder's 32 levels of 4 children need 97
  std::array<const OccluderNode*, kStack> stack;
  size_t depth = 0;
  stack[depth++] = root;
  while (depth > 0) {
    const OccluderNode* node = stack[--depth];
    if (node->triangle_count > 0) {
      meet_leaf(walk, *static_cast<const OccluderLeaf*>(node));
      continue;
    }
    const auto& inner = *static_cast<const OccluderInner*>(node);
    const LaneMask lanes = undecided(walk);
    int32_t any = 0;
    for (const int32_t lane : lanes) any |= lane;
    if (any == 0) return;
    for (uint32_t k = 0; k < inner.child_count; ++k) {
      if (meets_any(walk, inner.boxes[k], lanes)) stack[depth++] = inner.children[k];
    }
  }
}

}  // namespace

PatchCorners corners_of(const LightPatch& patch) {
  constexpr float kA[4] = {-1, 1, 1, -1}, kB[4] = {-1, -1, 1, 1};
  PatchCorners corners;
  for (size_t k = 0; k < 4; ++k) {
    const glm::vec3 way{patch.direction_x.at(kA[k], kB[k]), patch.direction_y.at(kA[k], kB[k]),
                        patch.direction_z.at(kA[k], kB[k])};
    corners.ways_world[k] = way;
    corners.greatest_length = std::max(corners.greatest_length, glm::length(way));
  }
  return corners;
}

float shaft_end(const LightPatch& patch, double scene_extent_world) {
  return patch.at_infinity ? 4.0f * static_cast<float>(scene_extent_world) : patch.end_fraction;
}

bool only_occluders_matter(const LightPatch& patch, const PatchCorners& corners) {
  return is_above_horizon(patch, corners.greatest_length) && has_plain_cosine(patch);
}

std::array<LightProof, kShafts> prove_light(const OccluderTree& tree, const Scene& scene,
                                            double scene_extent_world, std::span<const ShaftPixel> pixels) {
  std::array<LightProof, kShafts> proofs{};
  LightShafts shafts{};
  shafts.extent = static_cast<float>(scene_extent_world);
  Walk walk{tree, scene.triangles.data(), scene.positions_world.data(), shafts, scene.first_cutout()};
  bool any_shaft = false;
  for (uint32_t i = 0; i < pixels.size(); ++i) {
    if (is_below_horizon(pixels[i].patch)) {
      proofs[i] = LightProof::below_horizon;
      continue;
    }
    any_shaft = true;
    walk.used[i] = -1;
    walk.lit[i] = add_shaft(shafts, i, pixels[i]) ? -1 : 0;
  }
  if (any_shaft && tree.root() != nullptr) walk_tree(tree.root(), walk);
  for (uint32_t i = 0; i < pixels.size(); ++i) {
    if (walk.covered[i] != 0) proofs[i] = LightProof::covered;
    if (walk.lit[i] != 0) proofs[i] = LightProof::lit;
  }
  return proofs;
}

}  // namespace umbrameter
