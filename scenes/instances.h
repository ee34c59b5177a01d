// SPDX-License-Identifier: Apache-2.0
#pragma once
// Meshes that stand in several places of a scene and are kept once: in memory, in Embree and in GL.
// Shown triangles are counted as if every instance had its own: scene.triangles first, then mesh by mesh, instance by instance
// and triangle by triangle. primitive_id is that number; beyond what a float tells apart it begins anew (shown_id).

#include "scenes/scene.h"

#include <glm/mat3x3.hpp>
#include <glm/mat4x3.hpp>

#include <array>
#include <span>

namespace umbrameter {

struct InstancedMesh {
  SharedList<glm::vec3> positions;  // in the mesh's own space
  SharedList<glm::vec3> normals;    // unit, per vertex; empty where the scene's are
  SharedList<glm::uvec3> triangles;
  std::vector<MeshPart> parts;
  SharedList<Cutout> cutouts;  // of the last triangles
  SharedList<AlphaMask> masks;
  Bounds3 bounds;
  std::vector<glm::mat4x3> world_from_mesh;  // one an instance; none mirrors, none flattens

  uint32_t first_cutout() const { return static_cast<uint32_t>(triangles.size() - cutouts.size()); }
};

/// One of a scene's instances; points into the scene.
struct Instance {
  const InstancedMesh* mesh = nullptr;
  const glm::mat4x3* world_from_mesh = nullptr;
  uint32_t first_shown = 0;  // shown number of its first triangle

  /// Of vertex `vertex`, in double: exact but for the last bit.
  glm::dvec3 p_world(uint32_t vertex) const;
  /// Unit shading normal of vertex `vertex`.
  glm::dvec3 n_world(uint32_t vertex) const;
  std::array<glm::dvec3, 3> corners_world(uint32_t triangle) const;
  /// Around the mesh's box where it stands: holds every point of the instance, not tightly.
  Bounds3 bounds_world() const;
};

/// All instances, in the order of their shown triangles.
std::vector<Instance> list_instances(const Scene& scene);

uint64_t count_shown_triangles(const Scene& scene);
/// Of those, the ones with holes.
uint64_t count_shown_cutouts(const Scene& scene);

/// Whether surfaces have shading normals: all of them, then.
bool has_shading_normals(const Scene& scene);

/// What primitive_id says of a shown triangle.
inline uint32_t shown_id(uint32_t shown_triangle) {
  return shown_triangle % (kMaxTriangles + 1);
}

/// The same scene with a triangle of its own for everything shown, as it would be without instances; positions are rounded to
/// floats where they stand. Without cutouts its triangles stand in the order of their shown numbers. Error{input} when there
/// are more than kMaxTriangles. For what knows no instances: exact answers, files for other renderers.
Scene flattened(const Scene& scene);

/// Whether a place turns boxes into something flat, or nothing into something. A mesh has a copy of its own there
/// (scenes/unroll.h), whatever its other places do.
bool squashes(const glm::dmat4& world_from_mesh);

/// The rule that decides whether a mesh in several places is kept once: at those that do not squash it copies would add
/// kLeastCopiedTriangles. Fewer triangles are copied: one tree over all of them is faster, and nothing changes for small
/// scenes.
bool is_kept_once(uint64_t triangles, std::span<const glm::dmat4> world_from_mesh);
inline constexpr uint64_t kLeastCopiedTriangles = 100'000;
/// Shown triangles are told apart in GL by 32 bits.
inline constexpr uint64_t kMaxShownTriangles = (uint64_t{1} << 32) - 2;

}  // namespace umbrameter
