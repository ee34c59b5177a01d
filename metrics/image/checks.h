// SPDX-License-Identifier: Apache-2.0
#pragma once
// What every metric demands of its input before it trusts a number.

#include "core/image.h"

#include <cstdint>
#include <span>
#include <string_view>

namespace umbrameter {

/// Visibilities may leave [0,1] by this much: a sum of rounded filter weights does.
inline constexpr float kVisibilityRounding = 1e-5f;

/// Error{input} unless `mask` has one value a pixel of `image`.
void require_mask_size(const Image& image, std::span<const uint8_t> mask, std::string_view what);

/// Error{input} naming channel, pixel and value at the first pixel (reading order, mask not 0) that is not
/// within [low, high]; NaN never is.
void require_range(const Image& image, std::string_view channel, std::span<const uint8_t> mask, float low,
                   float high);

/// require_range for a visibility: [0,1] and kVisibilityRounding.
void require_visibility(const Image& image, std::string_view channel, std::span<const uint8_t> mask);

}  // namespace umbrameter
