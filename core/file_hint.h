// SPDX-License-Identifier: Apache-2.0
#pragma once
// Spelling help for files that are not there.

#include <filesystem>
#include <string>

namespace umbrameter {

/// "did you mean 'x'?" with the entry of the same folder whose name is nearest; "there is no folder 'y'" when that is what is
/// missing; empty when nothing is near.
std::string hint_for_missing(const std::filesystem::path& file);

}  // namespace umbrameter
