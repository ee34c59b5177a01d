// SPDX-License-Identifier: Apache-2.0
#pragma once
// Which moment of a file's animation a scene shows. Not here: what moves (scenes/gltf/gltf_animation.h, scenes/assimp/).

#include <compare>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace umbrameter {

struct AnimationTime {
  double time_s = 0.0;
  std::string animation = {};  // a name, a number counted from 1, or "all" at once; empty = the first
  auto operator<=>(const AnimationTime&) const = default;
};

/// A mesh of a scene at a moment of its file's animation.
struct AnimatedMesh {
  std::string mesh;       // name of the [[mesh]]
  std::string file;       // as the scene file names it
  std::string animation;  // the name of what is shown; several are joined with " + "
  double time_s = 0.0;
};

/// What the view of a scene at a moment is called: "scene", or "scene@0.5s".
std::string timed_name(const std::string& scene, const std::optional<AnimationTime>& at);

/// The animations, of `names` (at least one), that `at` takes. Of several without a choice the first, with a line in
/// `warnings`. Error{input} with the names for one that is not there.
std::vector<size_t> choose_animations(const std::vector<std::string>& names, const AnimationTime& at,
                                      const std::filesystem::path& file, std::vector<std::string>& warnings);

/// Their names for people, as AnimatedMesh has them.
std::string joined_names(const std::vector<std::string>& names, const std::vector<size_t>& chosen);

/// Where a moment lies among keys: at `before` where `fraction` is 0, on the way to `after` else.
struct KeySpan {
  size_t before = 0, after = 0;
  double fraction = 0.0;  // [0, 1)
  double length_s = 0.0;  // between the two keys
};

/// `times_s` must not be empty nor fall. Before the first key that one holds, after the last one that; of keys at one time the
/// last counts.
KeySpan find_keys(std::span<const double> times_s, double time_s);

/// Error{input}: a file that has no animation is to be shown at a moment.
[[noreturn]] void fail_not_animated(const std::filesystem::path& file, double time_s);

/// Says that a file's animations, if it has any, are not shown.
void warn_of_animations(const std::vector<std::string>& names, const std::filesystem::path& file,
                        std::vector<std::string>& warnings);

/// Says that a moment before the first or after the last key of everything that moves shows that key.
void warn_if_held(double time_s, double first_s, double last_s, const std::string& animation,
                  const std::filesystem::path& file, std::vector<std::string>& warnings);

}  // namespace umbrameter
