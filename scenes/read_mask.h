// SPDX-License-Identifier: Apache-2.0
#pragma once
// Alpha masks from pictures.

#include "core/image.h"
#include "scenes/cutouts.h"

#include <filesystem>
#include <optional>

namespace umbrameter {

/// `alpha` times the picture's alpha channel, else its first channel, is solid from kLeastAlpha on. The picture's lowest
/// row is v = 0. Error{input} for a picture that cannot be read.
AlphaMask read_mask(const std::filesystem::path& path, float alpha);

/// The same by the alpha channel alone, of a picture called `name` that is loaded already. Absent without one.
std::optional<AlphaMask> mask_by_alpha(const Image& image, const std::string& name, float alpha);

}  // namespace umbrameter
