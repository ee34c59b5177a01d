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

/// How a texture's colour says what is there.
struct ColourMask {
  bool is_luminance = false;  // Rec. 709's of R, G and B; else the first channel counts
  bool is_encoded = true;     // whole numbers are sRGB-encoded, and made linear; floats are linear
  float scale = 1.0f;
  bool inverts = false;  // 1 minus the scaled value
};

/// By the picture's colour, never by its alpha channel: solid from kLeastAlpha on. Error{input} as read_mask().
AlphaMask mask_by_colour(const std::filesystem::path& path, const ColourMask& how);

}  // namespace umbrameter
