// SPDX-License-Identifier: Apache-2.0
#pragma once
// A technique's shaders in other languages, by the programs glslangValidator and spirv-cross.

#include "realtime/inspect.h"

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace umbrameter {

/// spirv: SPIR-V 1.0 for Vulkan; hlsl: shader model 5.0; msl: Metal 1.2 or what a shader needs; essl: GLSL ES 3.10.
enum class ShaderLanguage : uint8_t { glsl, spirv, hlsl, msl, essl };

/// "glsl", "spirv", "hlsl", "msl" or "essl"; Error{input} with the nearest otherwise.
ShaderLanguage choose_shader_language(const std::string& name);

/// What a file of this language and stage ends in: ".frag", ".frag.hlsl".
std::string file_ending(ShaderLanguage language, std::string_view stage);

/// The bytes of a file in that language. Uniforms outside blocks come to lie in one block, bindings are numbered anew.
/// `work_folder` takes what lies between. Error{environment} when a program is not there, Error{input} with its words when
/// the language cannot say what the shader does.
std::string translate(const FinalShader& shader, ShaderLanguage language,
                      const std::filesystem::path& work_folder);

}  // namespace umbrameter
