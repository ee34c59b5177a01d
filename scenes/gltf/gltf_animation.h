// SPDX-License-Identifier: Apache-2.0
#pragma once
// A glTF file's animations at one moment (glTF 2.0, 3.11 and appendix C).

#include "scenes/animation_time.h"
#include "scenes/gltf/gltf_model.h"

#include <glm/gtc/quaternion.hpp>
#include <glm/vec3.hpp>

#include <optional>
#include <vector>

namespace umbrameter {

/// What an animation says of a node; what is absent stays as the file has it.
struct GltfPose {
  std::optional<glm::dvec3> translation, scale;
  std::optional<glm::dquat> rotation;
  std::optional<std::vector<double>> weights;  // of morph targets

  bool moves() const { return translation || scale || rotation; }
};

/// By node of the model, at `at`; sets file.animation. Before its first key a channel holds that one, after its last one that.
/// Which animation is shown, what is held, and channels that are left out are said in file.warnings. All poses are empty, and
/// so is file.animation, where the file has no animation. Error{input} for an animation that is not there, samplers and accessors
/// that are missing or do not fit, key times that are not finite or fall, values that are not finite, and two channels for one
/// thing.
std::vector<GltfPose> pose_gltf(GltfFile& file, const AnimationTime& at);

}  // namespace umbrameter
