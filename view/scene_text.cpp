// SPDX-License-Identifier: Apache-2.0
#include "view/scene_text.h"

#include "core/files.h"
#include "core/toml.h"
#include "core/toml_text.h"
#include "scenes/import_scene.h"
#include "scenes/scene_text.h"

#include <algorithm>
#include <sstream>

namespace umbrameter {
namespace {

namespace fs = std::filesystem;

/// What a line of a TOML file opens: "camera" of [camera] and [[camera]]; empty for other lines.
std::string table_of(const std::string& line) {
  const size_t first = line.find_first_not_of(" \t");
  if (first == std::string::npos || line[first] != '[') return {};
  const size_t begin = line.find_first_not_of("[ \t", first), end = line.find_first_of("] \t", begin);
  return end == std::string::npos ? std::string() : line.substr(begin, end - begin);
}

/// `file` as it is found from the target's folder, when it lies beside the scene.
std::string file_line(const std::string& line, const fs::path& from, const fs::path& to) {
  const size_t begin = line.find('"'), end = line.rfind('"');
  if (begin == std::string::npos || end <= begin) return line;
  const fs::path file = line.substr(begin + 1, end - begin - 1);
  std::error_code ignored;
  if (file.is_absolute() || !fs::exists(from / file, ignored)) return line;
  return line.substr(0, begin) + toml_string(fs::relative(from / file, to).generic_string()) +
         line.substr(end + 1);
}

/// What the scene file says; of another program's file what `scene import` would write. A sentence where it is no TOML.
std::string source_toml(const fs::path& scene_file, const std::optional<AnimationTime>& at) {
  if (is_importable(scene_file.string())) return import_file(scene_file, at).toml;
  std::string source = read_file(scene_file);
  parse_toml(source, scene_file.string());
  return source;
}

/// What a [[mesh]] of that file gets; nothing where it is not animated.
std::string time_lines(const Scene& scene, const AnimationTime& at, const std::string& file_line) {
  const size_t begin = file_line.find('"'), end = file_line.rfind('"');
  const bool is_animated = std::ranges::any_of(scene.animated, [&](const AnimatedMesh& mesh) {
    return end > begin && end != std::string::npos &&
           file_line.substr(begin + 1, end - begin - 1) == mesh.file;
  });
  if (!is_animated) return {};
  std::string text = fmt::format("time = {}\n", toml_number(at.time_s));
  if (!at.animation.empty()) text += fmt::format("animation = {}\n", toml_string(at.animation));
  return text;
}

fs::path folder_of(const fs::path& file) {
  return fs::absolute(file).parent_path();
}

std::string changed_values(std::span<const Parameter> parameters, const ParameterValues& values) {
  std::string text;
  for (const Parameter& parameter : parameters) {
    const auto value = values.find(parameter.name);
    if (value == values.end() || value->second == parameter.default_value) continue;
    text += fmt::format("{} = {}\n", parameter.name, toml_value(value->second));
  }
  return text;
}

}  // namespace

std::string scene_toml(const Scene& scene, const std::optional<AnimationTime>& at, const fs::path& target,
                       const Camera& camera, const Light& light) {
  const fs::path scene_file = scene.source.file;
  const std::string source = source_toml(scene_file, at);
  const bool sets_time = at && !is_importable(scene_file.string());
  std::istringstream lines(source);
  std::string text, line, table;
  bool has_light = false, has_camera = false;
  while (std::getline(lines, line)) {
    if (const std::string opened = table_of(line); !opened.empty()) {
      table = opened;
      const bool is_first_light = table == "light" && !has_light;
      has_light = has_light || is_first_light;
      has_camera = has_camera || table == "camera";
      if (table == "camera") text += "[camera]\n" + camera_keys(camera) + "\n";
      if (is_first_light) text += "[[light]]\n" + light_keys(light) + "\n";
    }
    if (table == "camera" || table == "light") continue;
    const bool is_mesh = table == "mesh", names_file = is_mesh && line.starts_with("file");
    const bool is_replaced =
        sets_time && is_mesh &&
        (line.starts_with("time") || (!at->animation.empty() && line.starts_with("animation")));
    if (is_replaced) continue;
    text += (names_file ? file_line(line, folder_of(scene_file), folder_of(target)) : line) + "\n";
    if (names_file && sets_time) text += time_lines(scene, *at, line);
  }
  if (!has_camera || !has_light)
    fail_input(fmt::format("{} is not a table of its own", has_camera ? "[[light]]" : "[camera]"),
               {scene_file.string()}, "the window replaces whole tables, so write it as one");
  return text;
}

std::string view_preset_toml(const std::string& technique, std::span<const Parameter> parameters,
                             const ParameterValues& values) {
  return fmt::format(
      "# Made in the window of `umbrameter view`: umbrameter render ... --preset FILE.\n"
      "technique = {}\n\n[[preset]]\nname = \"view\"\ndoc = \"Set by hand.\"\n[preset.values]\n{}",
      toml_string(technique), changed_values(parameters, values));
}

std::string view_study_toml(const std::string& scene, const std::string& technique,
                            std::span<const Parameter> parameters, const ParameterValues& values,
                            int width_px, int height_px) {
  return fmt::format(
      "# Made in the window of `umbrameter view`: umbrameter sweep FILE.\n"
      "schema = 1\ntitle = \"{} as set by hand\"\nscenes = [{}]\nwidth_px = {}\nheight_px = {}\n\n"
      "[[run]]\ntechnique = {}\n[run.values]\n{}",
      technique, toml_string(scene), width_px, height_px, toml_string(technique),
      changed_values(parameters, values));
}

}  // namespace umbrameter
