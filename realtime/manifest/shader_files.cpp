// SPDX-License-Identifier: Apache-2.0
#include "realtime/manifest/shader_files.h"

#include "realtime/harness/shader_source.h"
#include "realtime/manifest/names.h"

#include <algorithm>
#include <cctype>

namespace umbrameter {
namespace {

bool is_word(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_';
}

void add_passes(ShaderFiles& files, const Technique& technique, const std::vector<PassDeclaration>& passes,
                const std::filesystem::path& shaders_folder) {
  for (const PassDeclaration& pass : passes) {
    add_passes(files, technique, pass.body, shaders_folder);
    for (const std::string& name : {pass.vertex, pass.fragment, pass.compute}) {
      if (name.empty()) continue;
      const auto file = find_shader(name, technique.folder, shaders_folder, pass.where);
      const ShaderSource source = load_shader_source(file, "", shader_search_folders(shaders_folder));
      collect_tokens(source.text, files.tokens);
      for (const auto& dependency : source.dependencies) {
        if (std::ranges::find(files.dependencies, dependency) != files.dependencies.end()) continue;
        files.dependencies.push_back(dependency);
      }
    }
  }
}

}  // namespace

void collect_tokens(std::string_view text, std::set<std::string, std::less<>>& tokens) {
  size_t at = 0;
  while (at < text.size()) {
    if (text.substr(at, 2) == "//") {
      at = std::min(text.find('\n', at), text.size());
    } else if (text.substr(at, 2) == "/*") {
      const size_t end = text.find("*/", at + 2);
      at = end == std::string_view::npos ? text.size() : end + 2;
    } else if (is_word(text[at])) {
      const size_t begin = at;
      while (at < text.size() && is_word(text[at])) ++at;
      tokens.emplace(text.substr(begin, at - begin));
    } else {
      ++at;
    }
  }
}

ShaderFiles read_shader_files(const Technique& technique, const std::filesystem::path& shaders_folder) {
  ShaderFiles files;
  add_passes(files, technique, technique.passes, shaders_folder);
  return files;
}

}  // namespace umbrameter
