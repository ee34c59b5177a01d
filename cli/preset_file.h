// SPDX-License-Identifier: Apache-2.0
#pragma once
// Presets in files of their own, as `tune` writes them (docs/tuning.md).

#include "core/parameters.h"
#include "realtime/manifest/technique.h"

#include <string>

namespace umbrameter {

/// Whether "preset=<text>" names a file instead of a preset of the manifest.
bool is_preset_file(const std::string& text);

/// The technique that the file is for; Error{input} when it is malformed.
std::string technique_of_preset(const std::string& file);

/// Its values; Error{input} at their place when they are not the technique's, or the file is for another one.
ParameterValues read_preset_file(const std::string& file, const Technique& technique);

}  // namespace umbrameter
