// SPDX-License-Identifier: Apache-2.0
#pragma once
// Runs of an earlier results folder beside those of now, so that a viewer can slide between both.

#include "results/results.h"

#include <filesystem>

namespace umbrameter {

/// At the end of an earlier run's label; report/assets/regress.js looks for it.
inline constexpr const char* kBeforeMark = " (before)";

/// Appends to each scene of `now` (in `folder`) the runs that `before` (in `before_folder`) has of it, marked. A scene that has
/// changed since, or was drawn at another size, gets a warning instead. Error{input} when no scene is in both.
void add_before(Results& now, const std::filesystem::path& folder, const Results& before,
                const std::filesystem::path& before_folder);

}  // namespace umbrameter
