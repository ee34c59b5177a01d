// SPDX-License-Identifier: Apache-2.0
#pragma once
// What a scene file of another renderer (Mitsuba, pbrt) says, in words of ours, and a scene file or a mesh made of it.

#include "scenes/foreign/tally.h"
#include "scenes/imported_scene.h"
#include "scenes/primitives.h"

#include <filesystem>
#include <string>
#include <vector>

namespace umbrameter {

/// One of ForeignScene::meshes where it stands.
struct ForeignShape {
  size_t mesh = 0;
  std::string name;                  // names its part of the mesh
  std::vector<std::string> aliases;  // what else it goes by in a filter
  glm::dmat4 world_from_mesh{1.0};
};

struct ForeignScene {
  std::filesystem::path path;
  std::vector<Primitive> meshes;  // each in its own space
  std::vector<AlphaMask> masks;
  std::vector<ForeignShape> shapes;
  std::vector<FoundCamera> cameras;
  std::vector<Light> lights;      // of shapes
  std::vector<FoundLight> lamps;  // without a size
  std::vector<std::filesystem::path> side_files;
  std::vector<std::string> mesh_warnings;
  Tally of_meshes, of_views;  // not carried over; views: cameras and lights
};

/// All shapes as one mesh; parts are shapes' names. `filter` goes by their names and aliases. A mesh that several shapes show is
/// kept once where is_kept_once() says so. Error{input} when nothing is left, there are more than kMaxTriangles, or a name of
/// the filter is not in the file.
MeshData foreign_mesh(ForeignScene scene, const MeshFilter& filter, std::vector<std::string>& warnings);

/// Its cameras and lights, as write_scene() takes them.
FoundScene find_foreign_scene(ForeignScene scene);

/// A mesh that was loaded, with `mask` for all of it (MeshMasks::given), or solid.
Primitive primitive_of(const MeshData& mesh, std::optional<uint32_t> mask);

/// Sets uv = uv_from_file * (u, v, 1) for all vertices; false where one is beyond kMaxUv, not finite, or all are the same: such
/// a mesh cannot have holes.
bool place_texture(Primitive& mesh, const glm::dmat3& uv_from_file);

}  // namespace umbrameter
