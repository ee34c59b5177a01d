// SPDX-License-Identifier: Apache-2.0
#pragma once
// How two runs of one label differ, from their texts (results/metadata.h).

#include <string>

namespace umbrameter {

/// "taps was 16 and is 25, fit is new and scene, bias_texels (0.5) is gone"; empty for equal texts.
std::string parameter_changes(const std::string& before, const std::string& now);

}  // namespace umbrameter
