// SPDX-License-Identifier: Apache-2.0
#pragma once
// The stability map: what `stress` found, techniques x axes, and every cell of every axis.

#include <filesystem>
#include <string>

namespace umbrameter {

/// Of every stress*.json in `folder` (study/stress/output.h); empty without one. Each cell of the map says its range in
/// data-detail, which report/assets/stress.js shows. Error{input} naming the file when one is malformed.
std::string stress_part(const std::filesystem::path& folder);

}  // namespace umbrameter
