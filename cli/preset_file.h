// SPDX-License-Identifier: Apache-2.0
#pragma once
// Presets in files of their own, as `tune` writes them (docs/tuning.md).

#include "core/parameters.h"
#include "realtime/manifest/technique.h"

#include <string>
#include <vector>

namespace umbrameter {

/// Whether "preset=<text>" names a file instead of a preset of the manifest.
bool is_preset_file(const std::string& text);

/// The technique that the file is for; Error{input} when it is malformed.
std::string technique_of_preset(const std::string& file);

/// Values for every light (`light` is empty), or for the light of that name.
struct LightPreset {
  std::string light;
  ParameterValues values;
};

/// One for every light, or one or several for a light each. Error{input} at their place when values are not the technique's,
/// or the file is for another one.
std::vector<LightPreset> read_preset_file(const std::string& file, const Technique& technique);

}  // namespace umbrameter
