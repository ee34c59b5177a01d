// SPDX-License-Identifier: Apache-2.0
#pragma once
// Whether files are still as they were, without reading them.

#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <vector>

namespace umbrameter {

/// Times and sizes of `files` and the times of their folders, one after the other: other numbers once a file was edited, came
/// or went. Absent where one is missing, or so new that its next change might not show.
std::optional<std::vector<int64_t>> stamps_of(std::span<const std::filesystem::path> files);

}  // namespace umbrameter
