// SPDX-License-Identifier: Apache-2.0
#pragma once
// glTF 2.0 files (.gltf, .glb) through tinygltf, checked before anything trusts them.

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

// tinygltf's header is large and has an implementation inside: only gltf/*.cpp include it, through tinygltf.h.
namespace tinygltf {
class Model;
struct Primitive;
}  // namespace tinygltf

namespace umbrameter {

/// A node of the default scene, or of all scenes when none is default.
struct GltfNode {
  int node = 0;  // in the model
  glm::dmat4 world_from_node{1.0};
};

struct GltfFile {
  std::filesystem::path path;
  std::shared_ptr<const tinygltf::Model> model;
  std::vector<GltfNode> nodes;                    // parents first
  std::vector<std::filesystem::path> side_files;  // buffers and pictures beside it
};

/// True for names that end in .gltf or .glb.
bool is_gltf(const std::string& name);

/// Error{input} for files that are cut off or no glTF, missing buffers, extensions that the geometry needs and we do not
/// read, nodes in a circle or with two parents, and transforms that are not finite.
GltfFile open_gltf(const std::filesystem::path& path);

/// One element per index, each of up to four components as doubles; integers that are `normalized` become fractions.
/// Error{input} for an accessor that reaches out of its buffer or is sparse.
std::vector<glm::dvec4> read_gltf_vectors(const GltfFile& file, int accessor, const std::string& what);
std::vector<uint32_t> read_gltf_indices(const GltfFile& file, int accessor);

/// "node 'Lamp'" or "node 7".
std::string gltf_node_name(const GltfFile& file, int node);

}  // namespace umbrameter
