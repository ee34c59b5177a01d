// SPDX-License-Identifier: Apache-2.0
#pragma once
// Where the scenes, techniques and shaders that belong to a program lie.

#include <filesystem>

namespace umbrameter {

/// The folder that holds scenes/library, realtime/techniques and realtime/shaders: UMBRAMETER_HOME when set and not empty,
/// else the nearest share/umbrameter beside or above the folder of `program`, at most `levels` folders up. An installed
/// tree has it at ../share/umbrameter, and so has a build tree (a link to the sources), so that no program knows where it
/// was built. Symbolic links are resolved. Error{environment} names the folder that is not there.
std::filesystem::path find_data_folder(const std::filesystem::path& program, int levels = 1);

/// The file this process was started from.
std::filesystem::path program_file();

}  // namespace umbrameter
