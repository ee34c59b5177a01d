// SPDX-License-Identifier: Apache-2.0
#pragma once
// Shader text: #include resolution and the way back from a driver's line numbers to the user's file. No GL.

#include "core/error.h"

#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace umbrameter {

/// What goes to the driver, and where each source number came from.
struct ShaderSource {
  std::string text;
  std::vector<std::string> files;  // files[n] is source number n of "#line 12 n"; 0 = the prelude
  std::vector<std::filesystem::path> dependencies;  // every file read, in order, each once
};

/// "#version 450 core", the prelude, then `file`. Both may #include "x": beside the including file first,
/// then in `search_folders` in order. A file is included once; a cycle, a depth over 16 or a missing file is
/// Error{input} at the #include, naming the chain.
ShaderSource load_shader_source(const std::filesystem::path& file, std::string_view prelude,
                                std::span<const std::filesystem::path> search_folders);

/// One message of a driver's log.
struct ShaderMessage {
  FileLocation where;  // file as in ShaderSource::files
  std::string text;
  bool is_error = false;
};

/// Understands Mesa ("0:12(3): error: x") and NVIDIA ("0(12) : error C1234: x"); other lines come back
/// without a place.
std::vector<ShaderMessage> parse_shader_log(std::string_view log, const ShaderSource& source);

/// What to do about a message that misses something a pass could have read: "noise_blue" undeclared -> list 'noise.blue'.
/// Empty for others.
std::string missing_read_hint(const std::string& message);

}  // namespace umbrameter
