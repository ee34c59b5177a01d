// SPDX-License-Identifier: Apache-2.0
#pragma once
// What manifests may name besides their own things, and how names reach GLSL.

#include "core/parameters.h"
#include "realtime/graph/expression.h"

#include <filesystem>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace umbrameter {

/// Built-in textures (gbuffer.* and noise.*) in a fixed order.
std::span<const std::string> builtin_reads();
inline constexpr std::string_view kVisibility = "visibility";
/// 64 x 64 texels of blue noise, the same in every frame.
inline constexpr std::string_view kBlueNoise = "noise.blue";

/// "previous.<resource or built-in>": a read of what it held at the end of the frame before.
inline constexpr std::string_view kPrevious = "previous.";
inline bool is_previous(std::string_view read) {
  return read.starts_with(kPrevious);
}
/// The resource or built-in behind a read, of this frame or the one before.
inline std::string_view without_previous(std::string_view read) {
  return is_previous(read) ? read.substr(kPrevious.size()) : read;
}
/// The resources, but for built-ins, whose previous contents some pass reads.
struct PassDeclaration;
std::set<std::string> read_previously(const std::vector<PassDeclaration>& passes);
/// Whether some pass reads `name`.
bool reads(const std::vector<PassDeclaration>& passes, std::string_view name);

/// A resource or built-in as GLSL sees it: dots become underscores.
std::string glsl_name(std::string_view name);
/// A parameter or choice as a macro: upper case, everything but letters and digits an underscore.
std::string macro_name(std::string_view name);
/// "<parameter>.<choice>": the name whose value in an expression is the choice's index.
std::string choice_variable(const Parameter& parameter, std::string_view choice);

/// Names that every expression may use next to the technique's parameters: screen.width and height (px);
/// light.width and height (full extent in world units; sun: 2 tan(half angle)); light.type and
/// light.rect, light.disk, light.sphere, light.sun to compare it with; scene.diagonal (world); and distances along the
/// camera's axis: camera.near (its near plane), camera.far (the farthest corner of the scene's box), receivers.near and
/// far (of the receivers in the picture).
std::span<const std::string> builtin_variables();
/// More of them for passes and views of a technique with history: frame.index, counted from the first frame that is drawn,
/// and frame.jitter_x and frame.jitter_y (HistoryData of realtime/shaders/shared/frame_data.h).
std::span<const std::string> frame_variables();

/// The value of every parameter and choice.
ExpressionVariables parameter_variables(std::span<const Parameter> parameters, const ParameterValues& values);

/// A shader file: in the technique's folder, else in shaders/lib, else in shaders/. Error{input} at `where`.
std::filesystem::path find_shader(const std::string& file, const std::filesystem::path& technique_folder,
                                  const std::filesystem::path& shaders_folder, const FileLocation& where);

/// Where #include looks after the including file's own folder.
std::vector<std::filesystem::path> shader_search_folders(const std::filesystem::path& shaders_folder);

}  // namespace umbrameter
