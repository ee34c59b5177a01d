// SPDX-License-Identifier: Apache-2.0
#pragma once
// A technique's answer must be a visibility before anyone measures it.

#include "core/image.h"

#include <optional>
#include <string>
#include <string_view>

namespace umbrameter {

/// Values this far outside [0,1] are rounding and stay unmentioned.
inline constexpr float kVisibilityTolerance = 1e-4f;

/// Error{input} naming `technique` and the first pixel that is not finite; else a warning when values lie
/// outside [0,1], with their number and the worst pixel.
std::optional<std::string> check_visibility(const Image& image, std::string_view technique);

}  // namespace umbrameter
