// SPDX-License-Identifier: Apache-2.0
#pragma once
// Alpha masks from pictures.

#include "scenes/cutouts.h"

#include <filesystem>

namespace umbrameter {

/// `alpha` times the picture's alpha channel, else its first channel, is solid from kLeastAlpha on. The picture's lowest
/// row is v = 0. Error{input} for a picture that cannot be read.
AlphaMask read_mask(const std::filesystem::path& path, float alpha);

}  // namespace umbrameter
