// SPDX-License-Identifier: Apache-2.0
#include "view/scene_text.h"

#include "core/files.h"
#include "core/toml.h"

#include <glm/trigonometric.hpp>

#include <sstream>

namespace umbrameter {
namespace {

namespace fs = std::filesystem;

std::string in_quotes(std::string_view text) {
  std::string out = "\"";
  for (const char letter : text) {
    if (letter == '"' || letter == '\\') out += '\\';
    out += letter;
  }
  return out + '"';
}

std::string vector3(const glm::dvec3& v) {
  return fmt::format("[{}, {}, {}]", toml_number(v.x), toml_number(v.y), toml_number(v.z));
}

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
  return line.substr(0, begin) + in_quotes(fs::relative(from / file, to).generic_string()) +
         line.substr(end + 1);
}

fs::path folder_of(const fs::path& file) {
  return fs::absolute(file).parent_path();
}

std::string changed_values(std::span<const Parameter> parameters, const ParameterValues& values) {
  std::string text;
  for (const Parameter& parameter : parameters) {
    const auto value = values.find(parameter.name);
    if (value == values.end() || value->second == parameter.default_value) continue;
    text += fmt::format("{} = {}\n", parameter.name, toml_text(value->second));
  }
  return text;
}

}  // namespace

std::string toml_number(double value) {
  const std::string text = fmt::format("{}", value);
  return text.find_first_of(".en") == std::string::npos ? text + ".0" : text;
}

std::string toml_text(const ParameterValue& value) {
  struct Writer {
    std::string operator()(bool flag) const { return flag ? "true" : "false"; }
    std::string operator()(int64_t number) const { return fmt::format("{}", number); }
    std::string operator()(double number) const { return toml_number(number); }
    std::string operator()(const std::string& text) const { return in_quotes(text); }
  };
  return std::visit(Writer{}, value);
}

std::string camera_keys(const Camera& camera) {
  return fmt::format("eye = {}\nat = {}\nup = {}\nfov_deg = {}\nnear = {}\n", vector3(camera.eye_world),
                     vector3(camera.at_world), vector3(camera.up_world), toml_number(camera.vertical_fov_deg),
                     toml_number(camera.near_world));
}

std::string light_keys(const Light& light) {
  std::string text =
      fmt::format("name = {}\ntype = {}\n", in_quotes(light.name), in_quotes(to_text(light.type)));
  if (light.type != LightType::sun) text += fmt::format("center = {}\n", vector3(light.center_world));
  text += fmt::format("direction = {}\ntangent = {}\n", vector3(light.direction_world),
                      vector3(light.tangent_world));
  switch (light.type) {
    case LightType::rect:
      return text + fmt::format("size = [{}, {}]\n", toml_number(light.size_world.x),
                                toml_number(light.size_world.y));
    case LightType::disk:
    case LightType::sphere:
      return text + fmt::format("radius = {}\n", toml_number(light.radius_world));
    case LightType::sun:
      return text + fmt::format("angular_diameter_deg = {}\n",
                                toml_number(2.0 * glm::degrees(light.half_angle_rad)));
  }
  return text;
}

std::string scene_toml(const fs::path& scene_file, const fs::path& target, const Camera& camera,
                       const Light& light) {
  const std::string source = read_file(scene_file);
  parse_toml(source, scene_file.string());  // a sentence, where it is none
  std::istringstream lines(source);
  std::string text, line, table;
  bool has_light = false;
  while (std::getline(lines, line)) {
    if (const std::string opened = table_of(line); !opened.empty()) {
      table = opened;
      const bool is_first_light = table == "light" && !has_light;
      has_light = has_light || is_first_light;
      if (table == "camera") text += "[camera]\n" + camera_keys(camera) + "\n";
      if (is_first_light) text += "[[light]]\n" + light_keys(light) + "\n";
    }
    if (table == "camera" || table == "light") continue;
    const bool names_file = table == "mesh" && line.starts_with("file");
    text += (names_file ? file_line(line, folder_of(scene_file), folder_of(target)) : line) + "\n";
  }
  return text;
}

std::string view_preset_toml(const std::string& technique, std::span<const Parameter> parameters,
                             const ParameterValues& values) {
  return fmt::format(
      "# Made in the window of `umbrameter view`: umbrameter render ... --preset FILE.\n"
      "technique = {}\n\n[[preset]]\nname = \"view\"\ndoc = \"Set by hand.\"\n[preset.values]\n{}",
      in_quotes(technique), changed_values(parameters, values));
}

std::string view_study_toml(const std::string& scene, const std::string& technique,
                            std::span<const Parameter> parameters, const ParameterValues& values,
                            int width_px, int height_px) {
  return fmt::format(
      "# Made in the window of `umbrameter view`: umbrameter sweep FILE.\n"
      "schema = 1\ntitle = \"{} as set by hand\"\nscenes = [{}]\nwidth_px = {}\nheight_px = {}\n\n"
      "[[run]]\ntechnique = {}\n[run.values]\n{}",
      technique, in_quotes(scene), width_px, height_px, in_quotes(technique),
      changed_values(parameters, values));
}

}  // namespace umbrameter
