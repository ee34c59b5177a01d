// SPDX-License-Identifier: Apache-2.0
#include "realtime/manifest/names.h"

#include "realtime/graph/pass.h"

#include <algorithm>
#include <array>
#include <cctype>

namespace umbrameter {

std::span<const std::string> builtin_reads() {
  static const std::array<std::string, 6> reads = {"gbuffer.position",       "gbuffer.normal",
                                                   "gbuffer.shading_normal", "gbuffer.primitive_id",
                                                   "gbuffer.depth",          std::string(kBlueNoise)};
  return reads;
}

bool reads(const std::vector<PassDeclaration>& passes, std::string_view name) {
  return std::ranges::any_of(passes, [&](const PassDeclaration& pass) {
    return std::ranges::find(pass.reads, name) != pass.reads.end() || reads(pass.body, name);
  });
}

std::string glsl_name(std::string_view name) {
  std::string result(name);
  for (char& c : result) c = c == '.' ? '_' : c;
  return result;
}

std::string macro_name(std::string_view name) {
  std::string result(name);
  for (char& c : result) {
    const auto letter = static_cast<unsigned char>(c);
    c = std::isalnum(letter) != 0 ? static_cast<char>(std::toupper(letter)) : '_';
  }
  return result;
}

std::string choice_variable(const Parameter& parameter, std::string_view choice) {
  return fmt::format("{}.{}", parameter.name, choice);
}

std::span<const std::string> builtin_variables() {
  static const std::array<std::string, 14> variables = {
      "screen.width", "screen.height", "light.width",    "light.height", "light.type",
      "light.rect",   "light.disk",    "light.sphere",   "light.sun",    "scene.diagonal",
      "camera.near",  "camera.far",    "receivers.near", "receivers.far"};
  return variables;
}

std::span<const std::string> frame_variables() {
  static const std::array<std::string, 3> variables = {"frame.index", "frame.jitter_x", "frame.jitter_y"};
  return variables;
}

std::set<std::string> read_previously(const std::vector<PassDeclaration>& passes) {
  std::set<std::string> names;
  for (const PassDeclaration& pass : passes) {
    names.merge(read_previously(pass.body));
    for (const std::string& read : pass.reads) {
      if (is_previous(read) && !read.substr(kPrevious.size()).starts_with("gbuffer."))
        names.emplace(without_previous(read));
    }
  }
  return names;
}

ExpressionVariables parameter_variables(std::span<const Parameter> parameters,
                                        const ParameterValues& values) {
  ExpressionVariables variables;
  for (const Parameter& parameter : parameters) {
    variables[parameter.name] = numeric_value(parameter, values.at(parameter.name));
    for (size_t k = 0; k < parameter.choices.size(); ++k) {
      variables[choice_variable(parameter, parameter.choices[k])] = static_cast<double>(k);
    }
  }
  return variables;
}

std::filesystem::path find_shader(const std::string& file, const std::filesystem::path& technique_folder,
                                  const std::filesystem::path& shaders_folder, const FileLocation& where) {
  for (const auto& folder : {technique_folder, shaders_folder / "lib", shaders_folder}) {
    if (std::filesystem::is_regular_file(folder / file)) return folder / file;
  }
  fail_input(fmt::format("shader file '{}' is missing", file), where,
             fmt::format("looked in {} and in the shader library", technique_folder.string()));
}

std::vector<std::filesystem::path> shader_search_folders(const std::filesystem::path& shaders_folder) {
  return {shaders_folder / "lib", shaders_folder / "shared"};
}

}  // namespace umbrameter
