// SPDX-License-Identifier: Apache-2.0
#pragma once
// A mesh on its way from a file or a shape to the scene, in doubles.

#include "scenes/cutouts.h"
#include "scenes/scene.h"

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

#include <filesystem>
#include <vector>

namespace umbrameter {

/// No entry in MeshData::cutouts.
inline constexpr uint32_t kSolid = ~0u;

struct RepeatedMesh;

struct MeshData {
  std::vector<glm::dvec3> positions;
  std::vector<glm::dvec3> normals;           // unit shading normals, one per position; empty = flat shading
  std::vector<glm::uvec3> triangles;         // indices into positions; counter-clockwise seen from outside
  std::vector<MeshPart> parts;               // cover `triangles` in order
  std::vector<uint32_t> cutout_of_triangle;  // index into cutouts or kSolid; empty = all solid
  std::vector<Cutout> cutouts;
  std::vector<AlphaMask> masks;
  std::vector<std::filesystem::path> side_files;  // material libraries and masks that were asked for
  std::string animation;                          // what of its file's animations it shows; empty: none
  size_t moved_views = 0;              // cameras and lights of the file that the animation moves, too
  std::vector<RepeatedMesh> repeated;  // besides the above: what is kept once (scenes/instances.h)
};

/// A mesh in a space of its own, and where it stands.
struct RepeatedMesh {
  MeshData mesh;  // has no repeated ones itself
  std::vector<glm::dmat4> world_from_mesh;
};

}  // namespace umbrameter
