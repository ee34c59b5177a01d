// SPDX-License-Identifier: Apache-2.0
#include "scenes/gltf/gltf_animation.h"

#include "core/error.h"
#include "scenes/gltf/gltf_accessor.h"
#include "scenes/gltf/tinygltf.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace umbrameter {
namespace {

enum class Interpolation : uint8_t { step, linear, cubic };

/// Keys of one channel: `width` values each, three times as many where they are cubic (in-tangent, value, out-tangent).
struct Keys {
  std::vector<double> times_s;
  std::vector<double> values;
  size_t width = 0;
  Interpolation interpolation = Interpolation::linear;

  size_t values_a_key() const { return interpolation == Interpolation::cubic ? 3 * width : width; }
  const double* value(size_t key) const {
    return values.data() + key * values_a_key() + (interpolation == Interpolation::cubic ? width : 0);
  }
  const double* in_tangent(size_t key) const { return values.data() + key * values_a_key(); }
  const double* out_tangent(size_t key) const { return value(key) + width; }
};

/// Each component for itself; `u` of the way from one key to the next.
std::vector<double> interpolated(const Keys& keys, const KeySpan& span) {
  const double* a = keys.value(span.before);
  const double* b = keys.value(span.after);
  const double u = span.fraction;
  std::vector<double> values(a, a + keys.width);
  if (u == 0.0 || keys.interpolation == Interpolation::step) return values;
  if (keys.interpolation == Interpolation::linear) {
    for (size_t i = 0; i < keys.width; ++i) values[i] = (1.0 - u) * a[i] + u * b[i];
    return values;
  }
  const double* leaves = keys.out_tangent(span.before);
  const double* arrives = keys.in_tangent(span.after);
  const double u2 = u * u, u3 = u2 * u;
  for (size_t i = 0; i < keys.width; ++i) {
    values[i] = (2 * u3 - 3 * u2 + 1) * a[i] + span.length_s * (u3 - 2 * u2 + u) * leaves[i] +
                (3 * u2 - 2 * u3) * b[i] + span.length_s * (u3 - u2) * arrives[i];
  }
  return values;
}

glm::dquat quaternion(const double* xyzw) {
  return {xyzw[3], xyzw[0], xyzw[1], xyzw[2]};
}

class Poser {
 public:
  Poser(GltfFile& file, const tinygltf::Animation& animation, std::string name, double time_s,
        std::vector<GltfPose>& poses)
      : file_(file), animation_(animation), name_(std::move(name)), time_s_(time_s), poses_(poses) {}

  void run() {
    for (size_t i = 0; i < animation_.channels.size(); ++i) {
      channel_ = i;
      pose(animation_.channels[i]);
    }
    if (left_out_ > 0)
      file_.warnings.push_back(
          fmt::format("{}: of animation '{}' {} channel{} left out: no node's place or morph targets",
                      file_.path.filename().string(), name_, left_out_, left_out_ == 1 ? " is" : "s are"));
    if (first_s_ <= last_s_) warn_if_held(time_s_, first_s_, last_s_, name_, file_.path, file_.warnings);
  }

 private:
  [[noreturn]] void fail(const std::string& message) const {
    fail_input(fmt::format("channel {} of animation '{}' {}", channel_, name_, message),
               {file_.path.string()});
  }

  const tinygltf::Node& node_of(const tinygltf::AnimationChannel& channel) const {
    return file_.model->nodes[static_cast<size_t>(channel.target_node)];
  }

  void pose(const tinygltf::AnimationChannel& channel) {
    const std::string& path = channel.target_path;
    const bool is_known = path == "translation" || path == "rotation" || path == "scale" || path == "weights";
    if (channel.target_node < 0 || !is_known) {
      ++left_out_;
      return;
    }
    if (static_cast<size_t>(channel.target_node) >= file_.model->nodes.size())
      fail(fmt::format("moves node {}, but there are {}", channel.target_node, file_.model->nodes.size()));
    if (path != "weights" && node_of(channel).matrix.size() == 16)
      fail(fmt::format("moves {}, which has a matrix", gltf_node_name(file_, channel.target_node)));
    GltfPose& target = poses_[static_cast<size_t>(channel.target_node)];
    const size_t width = path == "weights" ? target_count(channel) : path == "rotation" ? 4 : 3;
    const Keys keys = read_keys(channel, width);
    first_s_ = std::min(first_s_, keys.times_s.front());
    last_s_ = std::max(last_s_, keys.times_s.back());
    const KeySpan span = find_keys(keys.times_s, time_s_);
    if (path == "rotation") {
      set(target.rotation, rotation_at(keys, span), channel);
      return;
    }
    const std::vector<double> values = interpolated(keys, span);
    if (path == "weights")
      set(target.weights, values, channel);
    else
      set(path == "scale" ? target.scale : target.translation, glm::dvec3(values[0], values[1], values[2]),
          channel);
  }

  template <class T>
  void set(std::optional<T>& target, const T& value, const tinygltf::AnimationChannel& channel) const {
    if (target)
      fail(fmt::format("moves the {} of {}, which another channel moves already", channel.target_path,
                       gltf_node_name(file_, channel.target_node)));
    target = value;
  }

  size_t target_count(const tinygltf::AnimationChannel& channel) const {
    const int mesh = node_of(channel).mesh;
    const auto& meshes = file_.model->meshes;
    const bool has_targets = mesh >= 0 && static_cast<size_t>(mesh) < meshes.size() &&
                             !meshes[static_cast<size_t>(mesh)].primitives.empty() &&
                             !meshes[static_cast<size_t>(mesh)].primitives.front().targets.empty();
    if (!has_targets)
      fail(fmt::format("moves weights of {}, which has no morph targets",
                       gltf_node_name(file_, channel.target_node)));
    return meshes[static_cast<size_t>(mesh)].primitives.front().targets.size();
  }

  glm::dquat rotation_at(const Keys& keys, const KeySpan& span) const {
    const bool is_slerp = keys.interpolation == Interpolation::linear && span.fraction > 0.0;
    const auto unit = [&](const double* xyzw) {
      const glm::dquat q = quaternion(xyzw);
      const double length = glm::length(q);
      if (!(length > 0.0)) fail("holds a rotation of length 0");
      return q / length;
    };
    if (is_slerp)  // the shorter way
      return glm::slerp(unit(keys.value(span.before)), unit(keys.value(span.after)), span.fraction);
    return unit(interpolated(keys, span).data());
  }

  Keys read_keys(const tinygltf::AnimationChannel& channel, size_t width) const {
    if (channel.sampler < 0 || static_cast<size_t>(channel.sampler) >= animation_.samplers.size())
      fail(fmt::format("names sampler {}, but there are {}", channel.sampler, animation_.samplers.size()));
    const tinygltf::AnimationSampler& sampler = animation_.samplers[static_cast<size_t>(channel.sampler)];
    Keys keys;
    keys.width = width;
    keys.interpolation = interpolation_of(sampler.interpolation);
    keys.times_s = read_gltf_numbers(file_, sampler.input, "key times").values;
    check_times(keys.times_s);
    keys.values = read_gltf_numbers(file_, sampler.output, "key values").values;
    const size_t wanted = keys.times_s.size() * keys.values_a_key();
    if (keys.values.size() != wanted)
      fail(fmt::format("has {} values for {} keys, not {}", keys.values.size(), keys.times_s.size(), wanted));
    if (!std::ranges::all_of(keys.values, [](double value) { return std::isfinite(value); }))
      fail("has a key whose value is not finite");
    return keys;
  }

  Interpolation interpolation_of(const std::string& name) const {
    if (name == "LINEAR") return Interpolation::linear;
    if (name == "STEP") return Interpolation::step;
    if (name == "CUBICSPLINE") return Interpolation::cubic;
    fail(fmt::format("has the interpolation '{}', which is not known", name));
  }

  void check_times(const std::vector<double>& times_s) const {
    if (times_s.empty()) fail("has no keys");
    for (size_t i = 0; i < times_s.size(); ++i) {
      if (!std::isfinite(times_s[i])) fail(fmt::format("has the time {} at key {}", times_s[i], i));
      if (i > 0 && times_s[i] < times_s[i - 1])
        fail(fmt::format("goes back in time at key {}: from {} s to {} s", i, times_s[i - 1], times_s[i]));
    }
  }

  GltfFile& file_;
  const tinygltf::Animation& animation_;
  std::string name_;
  double time_s_;
  std::vector<GltfPose>& poses_;
  size_t channel_ = 0, left_out_ = 0;
  double first_s_ = std::numeric_limits<double>::infinity();
  double last_s_ = -std::numeric_limits<double>::infinity();
};

}  // namespace

std::vector<GltfPose> pose_gltf(GltfFile& file, const AnimationTime& at) {
  std::vector<GltfPose> poses(file.model->nodes.size());
  const std::vector<std::string> names = gltf_animation_names(file);
  if (names.empty()) return poses;
  if (!file.animation_problem.empty())
    fail_input(fmt::format("its animations cannot be read: {}", file.animation_problem),
               {file.path.string()});
  const std::vector<size_t> chosen = choose_animations(names, at, file.path, file.warnings);
  for (const size_t i : chosen) Poser(file, file.model->animations[i], names[i], at.time_s, poses).run();
  file.animation = joined_names(names, chosen);
  return poses;
}

}  // namespace umbrameter
