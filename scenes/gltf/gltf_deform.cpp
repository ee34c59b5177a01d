// SPDX-License-Identifier: Apache-2.0
#include "scenes/gltf/gltf_deform.h"

#include "core/error.h"
#include "scenes/gltf/gltf_accessor.h"
#include "scenes/gltf/tinygltf.h"

#include <glm/gtc/type_ptr.hpp>

#include <algorithm>
#include <cmath>

namespace umbrameter {
namespace {

[[noreturn]] void fail_deform(const GltfFile& file, const std::string& message) {
  fail_input(message, {file.path.string()});
}

const int* find_target(const std::map<std::string, int>& target, const char* name) {
  const auto found = target.find(name);
  return found == target.end() ? nullptr : &found->second;
}

/// One displacement a vertex; empty where the target has none.
std::vector<glm::dvec4> displacements(const GltfFile& file, const std::map<std::string, int>& target,
                                      const char* name, size_t vertex_count) {
  const int* accessor = find_target(target, name);
  if (accessor == nullptr) return {};
  std::vector<glm::dvec4> vectors = read_gltf_vectors(file, *accessor, "morph target");
  if (vectors.size() != vertex_count)
    fail_deform(
        file, fmt::format("a morph target has {} vertices, its primitive {}", vectors.size(), vertex_count));
  return vectors;
}

const tinygltf::Skin& skin_of(const GltfFile& file, int skin) {
  const auto& skins = file.model->skins;
  if (skin < 0 || static_cast<size_t>(skin) >= skins.size())
    fail_deform(file, fmt::format("skin {} is named, but there are {}", skin, skins.size()));
  if (skins[static_cast<size_t>(skin)].joints.empty())
    fail_deform(file, fmt::format("skin {} has no joints", skin));
  return skins[static_cast<size_t>(skin)];
}

std::vector<glm::dmat4> read_joints(const GltfFile& file, int skin) {
  const tinygltf::Skin& source = skin_of(file, skin);
  std::vector<glm::dmat4> joint_from_mesh(source.joints.size(), glm::dmat4(1.0));
  if (source.inverseBindMatrices >= 0) {
    const GltfNumbers numbers = read_gltf_numbers(file, source.inverseBindMatrices, "inverse bind matrices");
    if (numbers.components != 16 || numbers.count < source.joints.size())
      fail_deform(file, fmt::format("skin {} has {} inverse bind matrices for {} joints", skin,
                                    numbers.components == 16 ? numbers.count : 0, source.joints.size()));
    if (!std::ranges::all_of(numbers.values, [](double value) { return std::isfinite(value); }))
      fail_deform(file, fmt::format("skin {} has an inverse bind matrix that is not finite", skin));
    for (size_t i = 0; i < source.joints.size(); ++i)
      joint_from_mesh[i] = glm::make_mat4(numbers.values.data() + 16 * i);
  }
  std::vector<glm::dmat4> world_from_mesh;
  for (size_t i = 0; i < source.joints.size(); ++i) {
    const auto joint = std::ranges::find(file.nodes, source.joints[i], &GltfNode::node);
    if (joint == file.nodes.end())
      fail_deform(file, fmt::format("skin {} has {} as a joint, which is not in the scene", skin,
                                    gltf_node_name(file, source.joints[i])));
    world_from_mesh.push_back(joint->world_from_node * joint_from_mesh[i]);
  }
  return world_from_mesh;
}

/// JOINTS_0 and WEIGHTS_0, and all sets that follow.
class InfluenceReader {
 public:
  InfluenceReader(const GltfFile& file, const tinygltf::Primitive& source, int skin, size_t vertex_count)
      : file_(file), source_(source), skin_(skin), vertex_count_(vertex_count) {}

  void read(Skinning& skinning) {
    while (add_set()) {
    }
    if (sets_.empty())
      fail_deform(file_, fmt::format("a primitive with skin {} has no JOINTS_0 and WEIGHTS_0", skin_));
    for (size_t v = 0; v < vertex_count_; ++v) {
      skinning.first_influence.push_back(skinning.influences.size());
      read_vertex(v, skinning);
    }
    skinning.first_influence.push_back(skinning.influences.size());
  }

 private:
  struct Set {
    std::vector<glm::dvec4> joints, weights;
  };

  bool add_set() {
    const size_t number = sets_.size();
    const int* joints = find_gltf_attribute(source_, fmt::format("JOINTS_{}", number));
    const int* weights = find_gltf_attribute(source_, fmt::format("WEIGHTS_{}", number));
    if (joints == nullptr && weights == nullptr) return false;
    if (joints == nullptr || weights == nullptr)
      fail_deform(file_, fmt::format("a primitive with skin {} has only one of JOINTS_{} and WEIGHTS_{}",
                                     skin_, number, number));
    sets_.push_back(
        {read_gltf_vectors(file_, *joints, "joints"), read_gltf_vectors(file_, *weights, "weights")});
    if (sets_.back().joints.size() != vertex_count_ || sets_.back().weights.size() != vertex_count_)
      fail_deform(file_, "a primitive has not as many joints and weights as positions");
    return true;
  }

  void read_vertex(size_t v, Skinning& skinning) const {
    const size_t first = skinning.influences.size();
    const size_t joint_count = skinning.world_from_mesh.size();
    double sum = 0.0;
    for (const Set& set : sets_) {
      for (int k = 0; k < 4; ++k) {
        const double weight = set.weights[v][k], joint = set.joints[v][k];
        if (!(weight >= 0.0) || !std::isfinite(weight))
          fail_deform(file_, fmt::format("vertex {} has the weight {} of a joint", v, weight));
        if (weight == 0.0) continue;  // its joint may be any number
        if (!(joint >= 0.0 && joint < static_cast<double>(joint_count)))
          fail_deform(
              file_, fmt::format("vertex {} has joint {}, but skin {} has {}", v, joint, skin_, joint_count));
        skinning.influences.push_back({static_cast<uint32_t>(joint), weight});
        sum += weight;
      }
    }
    if (!(std::abs(sum - 1.0) <= kWeightSumError))
      fail_deform(file_, fmt::format("the weights of vertex {} sum to {:.4g}, not to 1", v, sum));
    for (size_t i = first; i < skinning.influences.size(); ++i) skinning.influences[i].weight /= sum;
  }

  const GltfFile& file_;
  const tinygltf::Primitive& source_;
  int skin_;
  size_t vertex_count_;
  std::vector<Set> sets_;
};

}  // namespace

const int* find_gltf_attribute(const tinygltf::Primitive& primitive, const std::string& name) {
  const auto found = primitive.attributes.find(name);
  return found == primitive.attributes.end() ? nullptr : &found->second;
}

void apply_gltf_morphs(const GltfFile& file, const tinygltf::Primitive& source,
                       std::span<const double> weights, Primitive& primitive) {
  const size_t count = primitive.vertices.size();
  for (size_t i = 0; i < weights.size(); ++i) {
    if (!std::isfinite(weights[i]))
      fail_deform(file, fmt::format("morph target {} has the weight {}", i, weights[i]));
    if (weights[i] == 0.0) continue;
    if (i >= source.targets.size())
      fail_deform(file, fmt::format("a mesh has weights for {} morph targets, but {} of them", weights.size(),
                                    source.targets.size()));
    const auto positions = displacements(file, source.targets[i], "POSITION", count);
    for (size_t v = 0; v < positions.size(); ++v)
      primitive.vertices[v].p += weights[i] * glm::dvec3(positions[v]);
    if (!primitive.has_normals) continue;
    const auto normals = displacements(file, source.targets[i], "NORMAL", count);
    for (size_t v = 0; v < normals.size(); ++v)
      primitive.vertices[v].n += weights[i] * glm::dvec3(normals[v]);
  }
}

Skinning read_gltf_skin(const GltfFile& file, const tinygltf::Primitive& source, int skin,
                        size_t vertex_count) {
  Skinning skinning;
  skinning.world_from_mesh = read_joints(file, skin);
  InfluenceReader(file, source, skin, vertex_count).read(skinning);
  return skinning;
}

}  // namespace umbrameter
