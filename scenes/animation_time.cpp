// SPDX-License-Identifier: Apache-2.0
#include "scenes/animation_time.h"

#include "core/error.h"
#include "core/names.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <numeric>

namespace umbrameter {
namespace {

constexpr const char* kAllAnimations = "all";

/// 0 for what is no number.
size_t animation_number(const std::string& text) {
  size_t number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  return error == std::errc{} && end == text.data() + text.size() ? number : 0;
}

/// "'walk', 'run'"; of many the first ones.
std::string quoted(const std::vector<std::string>& names) {
  constexpr size_t kMost = 8;
  std::vector<std::string> shown;
  for (size_t i = 0; i < std::min(names.size(), kMost); ++i) shown.push_back(fmt::format("'{}'", names[i]));
  return fmt::format("{}{}", fmt::join(shown, ", "), names.size() > kMost ? ", ..." : "");
}

}  // namespace

void fail_not_animated(const std::filesystem::path& file, double time_s) {
  fail_input(fmt::format("it cannot be shown at {:g} s: it has no animation", time_s), {file.string()});
}

void warn_of_animations(const std::vector<std::string>& names, const std::filesystem::path& file,
                        std::vector<std::string>& warnings) {
  if (names.empty()) return;
  warnings.push_back(fmt::format("{}: {} animation{} not shown ({}): 'time' or --time chooses a moment",
                                 file.filename().string(), names.size(), names.size() == 1 ? " is" : "s are",
                                 quoted(names)));
}

std::string timed_name(const std::string& scene, const std::optional<AnimationTime>& at) {
  return at ? fmt::format("{}@{}s", scene, at->time_s) : scene;
}

std::vector<size_t> choose_animations(const std::vector<std::string>& names, const AnimationTime& at,
                                      const std::filesystem::path& file, std::vector<std::string>& warnings) {
  if (at.animation.empty()) {
    if (names.size() > 1)
      warnings.push_back(fmt::format("{}: it has {} animations ({}); '{}' is shown", file.filename().string(),
                                     names.size(), quoted(names), names.front()));
    return {0};
  }
  const auto found = std::find(names.begin(), names.end(), at.animation);
  if (found != names.end()) return {static_cast<size_t>(found - names.begin())};
  if (at.animation == kAllAnimations) {
    std::vector<size_t> all(names.size());
    std::iota(all.begin(), all.end(), size_t{0});
    return all;
  }
  const size_t number = animation_number(at.animation);
  if (number >= 1 && number <= names.size()) return {number - 1};
  fail_input(fmt::format("no animation is called '{}'", at.animation), {file.string()},
             fmt::format("there {} {}; numbers go from 1 to {}, and 'all' shows all of them at once",
                         names.size() == 1 ? "is" : "are", quoted(names), names.size()));
}

std::string joined_names(const std::vector<std::string>& names, const std::vector<size_t>& chosen) {
  std::vector<std::string> taken;
  for (const size_t i : chosen) taken.push_back(names[i]);
  return fmt::format("{}", fmt::join(taken, " + "));
}

KeySpan find_keys(std::span<const double> times_s, double time_s) {
  const auto later = std::upper_bound(times_s.begin(), times_s.end(), time_s);
  if (later == times_s.begin()) return {};
  const auto after = static_cast<size_t>(later - times_s.begin());
  if (later == times_s.end()) return {after - 1, after - 1, 0.0, 0.0};
  const double length_s = times_s[after] - times_s[after - 1];
  return {after - 1, after, (time_s - times_s[after - 1]) / length_s, length_s};
}

void warn_if_held(double time_s, double first_s, double last_s, const std::string& animation,
                  const std::filesystem::path& file, std::vector<std::string>& warnings) {
  const auto warn = [&](const char* side, const char* key, double key_s) {
    warnings.push_back(fmt::format("{}: {:g} s lies {} the {} key of animation '{}' at {:g} s, which holds",
                                   file.filename().string(), time_s, side, key, animation, key_s));
  };
  if (time_s > last_s) warn("beyond", "last", last_s);
  if (time_s < first_s) warn("before", "first", first_s);
}

}  // namespace umbrameter
