// SPDX-License-Identifier: Apache-2.0
#include "scenes/choose_light.h"

#include "core/names.h"
#include "scenes/scene_hash.h"

#include <algorithm>
#include <charconv>
#include <numeric>

namespace umbrameter {
namespace {

/// 0 for what is no number.
size_t whole_number(const std::string& text) {
  size_t number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  return error == std::errc{} && end == text.data() + text.size() ? number : 0;
}

}  // namespace

size_t find_light(const std::vector<Light>& lights, const std::string& text) {
  std::vector<std::string> names;
  for (const Light& light : lights) names.push_back(light.name);
  const auto found = std::find(names.begin(), names.end(), text);
  if (found != names.end()) return static_cast<size_t>(found - names.begin());
  const size_t number = whole_number(text);
  if (number >= 1 && number <= lights.size()) return number - 1;
  fail_input(fmt::format("the scene has no light '{}'", text), {},
             suggest_name(text, names) + fmt::format("; numbers go from 1 to {}", lights.size()));
}

std::vector<size_t> choose_lights(const std::vector<Light>& lights, const std::string& text) {
  if (!text.empty()) return {find_light(lights, text)};
  std::vector<size_t> all(lights.size());
  std::iota(all.begin(), all.end(), size_t{0});
  return all;
}

std::string lit_name(const std::string& scene, const std::vector<Light>& lights, size_t light) {
  return lights.size() == 1 ? scene : scene + "/" + lights.at(light).name;
}

Scene lit_by(Scene scene, size_t light) {
  const bool is_only_one = scene.lights.size() == 1 && light == 0;
  if (is_only_one) return scene;
  scene.lights = {scene.lights.at(light)};
  scene.active_light = 0;
  scene.hash = hash_scene(scene);
  return scene;
}

}  // namespace umbrameter
