// SPDX-License-Identifier: Apache-2.0
#include "cli/shader_languages.h"

#include "core/error.h"
#include "core/files.h"
#include "core/names.h"
#include "core/run_program.h"

#include <fmt/format.h>

#include <array>

namespace umbrameter {
namespace {

namespace fs = std::filesystem;

const std::array<std::string, 5> kNames = {"glsl", "spirv", "hlsl", "msl", "essl"};
constexpr std::array<std::string_view, 5> kEndings = {"", ".spv", ".hlsl", ".metal", ".es"};
constexpr const char* kHint = "install glslang-tools and spirv-cross";

std::string_view stage_ending(std::string_view stage) {
  if (stage == "vertex") return ".vert";
  if (stage == "compute") return ".comp";
  return ".frag";
}

/// What spirv-cross is told.
std::vector<std::string> dialect(ShaderLanguage language) {
  switch (language) {
    case ShaderLanguage::hlsl:
      return {"--hlsl", "--shader-model", "50"};
    case ShaderLanguage::msl:
      return {"--msl"};
    case ShaderLanguage::essl:
      return {"--es", "--version", "310"};
    case ShaderLanguage::glsl:
    case ShaderLanguage::spirv:
      break;
  }
  return {};
}

void run(const std::vector<std::string>& arguments, const FinalShader& shader, const fs::path& folder) {
  ProgramEnd end;
  try {
    end = run_program(arguments, folder / "messages");
  } catch (const Error& error) {
    if (error.kind() != ErrorKind::environment) throw;
    fail_environment(error.what(), kHint);
  }
  if (end.exit_code == 0) return;
  fail_input(fmt::format("{} does not take the {} shader of pass '{}': {}", arguments.front(), shader.stage,
                         shader.pass, end.messages));
}

}  // namespace

ShaderLanguage choose_shader_language(const std::string& name) {
  for (size_t k = 0; k < kNames.size(); ++k) {
    if (name == kNames[k]) return static_cast<ShaderLanguage>(k);
  }
  fail_input(fmt::format("unknown shader language '{}'", name), {}, suggest_name(name, kNames));
}

std::string file_ending(ShaderLanguage language, std::string_view stage) {
  return fmt::format("{}{}", stage_ending(stage), kEndings[static_cast<size_t>(language)]);
}

std::string translate(const FinalShader& shader, ShaderLanguage language, const fs::path& work_folder) {
  if (language == ShaderLanguage::glsl) return shader.text;
  const fs::path source = work_folder / fmt::format("shader{}", stage_ending(shader.stage));
  const fs::path spirv = work_folder / "shader.spv", target = work_folder / "shader.out";
  write_file_atomically(source, shader.text);
  // -R: uniforms outside blocks, which Vulkan itself does not have.
  run({"glslangValidator", "-V", "-R", "--auto-map-locations", "--auto-map-bindings", source.string(), "-o",
       spirv.string()},
      shader, work_folder);
  if (language == ShaderLanguage::spirv) return read_file(spirv);
  std::vector<std::string> arguments{"spirv-cross", spirv.string(), "--output", target.string()};
  const auto words = dialect(language);
  arguments.insert(arguments.end(), words.begin(), words.end());
  run(arguments, shader, work_folder);
  return read_file(target);
}

}  // namespace umbrameter
