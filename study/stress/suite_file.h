// SPDX-License-Identifier: Apache-2.0
#pragma once
// What a stress suite's file says (docs/stability.md). Not here: whether techniques exist (cli/).

#include "study/stress/run.h"

#include <filesystem>
#include <string>
#include <string_view>

namespace umbrameter {

/// Error{input} with file, line and hint.
StressPlan parse_stress_suite(std::string_view document, const std::string& file);
StressPlan load_stress_suite(const std::filesystem::path& path);

/// Every axis with all its values, every technique.
StressPlan full_stress_plan();

}  // namespace umbrameter
