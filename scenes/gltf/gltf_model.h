// SPDX-License-Identifier: Apache-2.0
#pragma once
// glTF 2.0 files (.gltf, .glb) through tinygltf, checked before anything trusts them.

#include "scenes/animation_time.h"

#include <glm/mat4x4.hpp>

#include <filesystem>
#include <memory>
#include <optional>
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
  bool is_moved = false;  // by the animation: itself, or a parent of it
};

struct GltfFile {
  std::filesystem::path path;
  std::shared_ptr<const tinygltf::Model> model;
  std::vector<GltfNode> nodes;                    // parents first
  std::vector<std::filesystem::path> side_files;  // buffers and pictures beside it
  std::string animation;  // name of what is shown; empty: nodes stand as the file has them
  std::vector<std::vector<double>> morph_weights;  // by node of the model; empty: none
  std::string animation_problem;                   // why its animations are no use; empty: they are
  std::vector<std::string> warnings;               // of animations
};

/// True for names that end in .gltf or .glb.
bool is_gltf(const std::string& name);

/// Error{input} for files that are cut off or no glTF, missing buffers, extensions that the geometry needs and we do not
/// read, nodes in a circle or with two parents, transforms that are not finite, and as pose_gltf(). With `at` nodes stand where
/// the animation has them then; without, animations are counted in the warnings.
GltfFile open_gltf(const std::filesystem::path& path, const std::optional<AnimationTime>& at = {});

/// A name for each animation: its own, or "animation 2".
std::vector<std::string> gltf_animation_names(const GltfFile& file);

/// "node 'Lamp'" or "node 7".
std::string gltf_node_name(const GltfFile& file, int node);

}  // namespace umbrameter
