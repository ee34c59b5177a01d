// SPDX-License-Identifier: Apache-2.0
#pragma once
// The shader files of a technique, with everything they include. Text only, no GL.

#include "realtime/manifest/technique.h"

#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace umbrameter {

struct ShaderFiles {
  std::vector<std::filesystem::path> dependencies;  // every file, each once
  std::set<std::string, std::less<>> tokens;        // every identifier outside comments
};

/// Error{input} when a file or an include is missing.
ShaderFiles read_shader_files(const Technique& technique, const std::filesystem::path& shaders_folder);

/// Adds the identifiers of GLSL `text`, comments left out.
void collect_tokens(std::string_view text, std::set<std::string, std::less<>>& tokens);

}  // namespace umbrameter
