// SPDX-License-Identifier: Apache-2.0
#pragma once
// PLY files, looked over before assimp gets them: it believes every count.

#include <filesystem>

namespace umbrameter {

/// Error{input} for a file that is no PLY file, holds less than its header promises, or has a list that reaches beyond the
/// end of the file.
void check_ply(const std::filesystem::path& path);

}  // namespace umbrameter
