// SPDX-License-Identifier: Apache-2.0
#pragma once
// A file that assimp reads, with its nodes where they stand.

#include "scenes/animation_time.h"

#include <glm/mat4x4.hpp>

#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

// assimp's headers are large: only assimp/*.cpp include them.
struct aiNode;
struct aiScene;
namespace Assimp {
class Importer;
}

namespace umbrameter {

struct AssimpNode {
  const aiNode* node = nullptr;
  glm::dmat4 world_from_node{1.0};
  bool is_moved = false;  // by the animation: itself, or a parent of it
};

struct AssimpFile {
  std::filesystem::path path;
  std::shared_ptr<Assimp::Importer> importer;  // owns the scene
  const aiScene* scene = nullptr;
  std::vector<AssimpNode> nodes;                             // parents first
  std::map<std::string, std::vector<double>> morph_weights;  // by the name of a node; absent: none
  std::string animation;              // name of what is shown; empty: nodes stand as the file has them
  std::vector<std::string> warnings;  // of animations
};

/// Triangles, with nodes in metres and y up where FBX says what it is in. With `at` nodes stand where the animation has them then:
/// assimp keeps its keys, and between them everything moves in straight lines (rotations along arcs). Without, animations are
/// counted in the warnings. Error{input} for what assimp cannot read, an animation that is not there, nodes nested deeper than 1000,
/// keys and transforms that are not finite, key times that fall, and two animations at once for one node.
AssimpFile open_assimp(const std::filesystem::path& path, const std::optional<AnimationTime>& at = {});

/// The node of that name; null where there is none.
const AssimpNode* find_node(const AssimpFile& file, const std::string& name);

}  // namespace umbrameter
