// SPDX-License-Identifier: Apache-2.0
#include "scenes/assimp/assimp_animation.h"

#include "core/error.h"
#include "scenes/assimp/assimp_values.h"

#include <assimp/anim.h>
#include <assimp/scene.h>

#include <algorithm>
#include <limits>
#include <set>
#include <span>

namespace umbrameter {
namespace {

constexpr double kUsualTicks_per_s = 25.0;  // where a file does not say
constexpr size_t kMostMorphTargets = 100'000;

class AssimpPoser {
 public:
  AssimpPoser(AssimpFile& file, const aiAnimation& animation, std::string name, AssimpPoses& poses)
      : file_(file), animation_(animation), name_(std::move(name)), poses_(poses) {}

  void run(double time_s) {
    const double ticks_per_s =
        animation_.mTicksPerSecond > 0.0 ? animation_.mTicksPerSecond : kUsualTicks_per_s;
    time_ticks_ = time_s * ticks_per_s;
    for (const aiNodeAnim* channel : std::span(animation_.mChannels, animation_.mNumChannels)) pose(*channel);
    for (const aiMeshMorphAnim* channel :
         std::span(animation_.mMorphMeshChannels, animation_.mNumMorphMeshChannels))
      morph(*channel);
    if (first_ticks_ <= last_ticks_)
      warn_if_held(time_s, first_ticks_ / ticks_per_s, last_ticks_ / ticks_per_s, name_, file_.path,
                   file_.warnings);
  }

 private:
  [[noreturn]] void fail(const std::string& what, const std::string& message) const {
    fail_input(fmt::format("animation '{}' of '{}' {}", name_, what, message), {file_.path.string()});
  }

  template <class Key>
  KeySpan find(const Key* keys, unsigned int count, const std::string& what) {
    std::vector<double> times_ticks;
    for (const Key& key : std::span(keys, count)) {
      if (!std::isfinite(key.mTime)) fail(what, fmt::format("has a key at the time {}", key.mTime));
      if (!times_ticks.empty() && key.mTime < times_ticks.back())
        fail(what, fmt::format("goes back in time from {} to {}", times_ticks.back(), key.mTime));
      times_ticks.push_back(key.mTime);
    }
    first_ticks_ = std::min(first_ticks_, keys[0].mTime);
    last_ticks_ = std::max(last_ticks_, keys[count - 1].mTime);
    return find_keys(times_ticks, time_ticks_);
  }

  glm::dvec3 vector_at(const aiVectorKey* keys, unsigned int count, const glm::dvec3& fallback,
                       const std::string& what) {
    if (count == 0) return fallback;
    const KeySpan span = find(keys, count, what);
    return glm::mix(vector_of(keys[span.before].mValue), vector_of(keys[span.after].mValue), span.fraction);
  }

  glm::dquat rotation_at(const aiNodeAnim& channel, const glm::dquat& fallback, const std::string& what) {
    if (channel.mNumRotationKeys == 0) return fallback;
    const KeySpan span = find(channel.mRotationKeys, channel.mNumRotationKeys, what);
    const glm::dquat a = quaternion_of(channel.mRotationKeys[span.before].mValue);
    const glm::dquat b = quaternion_of(channel.mRotationKeys[span.after].mValue);
    if (!(glm::length(a) > 0.0 && glm::length(b) > 0.0)) fail(what, "holds a rotation of length 0");
    return glm::slerp(glm::normalize(a), glm::normalize(b), span.fraction);
  }

  void pose(const aiNodeAnim& channel) {
    const std::string node = channel.mNodeName.C_Str();
    const aiNode* target = file_.scene->mRootNode->FindNode(channel.mNodeName);
    if (target == nullptr) return;  // moves nothing that is there
    aiVector3D scale, place;
    aiQuaternion turn;
    target->mTransformation.Decompose(scale, turn, place);
    const glm::dvec3 translation =
        vector_at(channel.mPositionKeys, channel.mNumPositionKeys, vector_of(place), node);
    const glm::dquat rotation = rotation_at(channel, quaternion_of(turn), node);
    const glm::dvec3 scaling =
        vector_at(channel.mScalingKeys, channel.mNumScalingKeys, vector_of(scale), node);
    glm::dmat4 parent_from_node = glm::mat4_cast(rotation);
    for (int axis = 0; axis < 3; ++axis) parent_from_node[axis] *= scaling[axis];
    parent_from_node[3] = glm::dvec4(translation, 1.0);
    if (!poses_.emplace(node, parent_from_node).second)
      fail(node, "moves what another one moves already: choose one of them");
  }

  /// The channel is called "node*0".
  void morph(const aiMeshMorphAnim& channel) {
    const std::string name = channel.mName.C_Str(), node = name.substr(0, name.rfind('*'));
    if (channel.mNumKeys == 0) return;
    const KeySpan span = find(channel.mKeys, channel.mNumKeys, node);
    std::vector<double> weights;
    const auto add = [&](const aiMeshMorphKey& key, double share) {
      for (unsigned int i = 0; i < key.mNumValuesAndWeights; ++i) {
        const size_t target = key.mValues[i];
        if (!std::isfinite(key.mWeights[i]) || target >= kMostMorphTargets)
          fail(node, fmt::format("gives morph target {} the weight {}", target, key.mWeights[i]));
        if (weights.size() <= target) weights.resize(target + 1, 0.0);
        weights[target] += share * key.mWeights[i];
      }
    };
    add(channel.mKeys[span.before], 1.0 - span.fraction);
    if (span.fraction > 0.0) add(channel.mKeys[span.after], span.fraction);
    if (!file_.morph_weights.emplace(node, std::move(weights)).second)
      fail(node, "morphs what another one morphs already: choose one of them");
  }

  AssimpFile& file_;
  const aiAnimation& animation_;
  std::string name_;
  AssimpPoses& poses_;
  double time_ticks_ = 0.0;
  double first_ticks_ = std::numeric_limits<double>::infinity();
  double last_ticks_ = -std::numeric_limits<double>::infinity();
};

}  // namespace

AssimpPoses pose_assimp(AssimpFile& file, const AnimationTime& at) {
  AssimpPoses poses;
  const std::vector<std::string> names = assimp_animation_names(file);
  if (names.empty()) return poses;
  const std::vector<size_t> chosen = choose_animations(names, at, file.path, file.warnings);
  for (const size_t i : chosen)
    AssimpPoser(file, *file.scene->mAnimations[i], names[i], poses).run(at.time_s);
  file.animation = joined_names(names, chosen);
  return poses;
}

std::vector<std::string> assimp_animation_names(const AssimpFile& file) {
  std::vector<std::string> names;
  for (const aiAnimation* animation : std::span(file.scene->mAnimations, file.scene->mNumAnimations)) {
    const std::string name = animation->mName.C_Str();
    names.push_back(name.empty() ? fmt::format("animation {}", names.size() + 1) : name);
  }
  return names;
}

}  // namespace umbrameter
