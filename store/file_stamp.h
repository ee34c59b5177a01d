// SPDX-License-Identifier: Apache-2.0
#pragma once
// What tells a changed file without reading it.

#include <filesystem>
#include <string>

namespace umbrameter {

/// "size mtime_ns"; "absent" for a missing file.
std::string file_stamp(const std::filesystem::path& file);

}  // namespace umbrameter
