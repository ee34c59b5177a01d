// SPDX-License-Identifier: Apache-2.0
#pragma once
// Positions are floats: far from the origin they are coarse, and what they bound is not what was meant.

#include "scenes/scene.h"

#include <optional>
#include <string>
#include <vector>

namespace umbrameter {

/// A warning when positions are rounded by more than a hundred thousandth of the scene's size, or a ten thousandth of how
/// far its camera looks.
std::optional<std::string> rounding_warning(const Scene& scene);

/// A warning for each light so narrow that rays cannot tell its parts: it is fewer than 256 roundings wide.
std::vector<std::string> narrow_light_warnings(const Scene& scene);

}  // namespace umbrameter
