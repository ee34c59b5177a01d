// SPDX-License-Identifier: Apache-2.0
#pragma once
// For every pixel, which of a set of pixels is nearest: exact, Euclidean, linear in the pixels.

#include <cstdint>
#include <span>
#include <vector>

namespace umbrameter {

/// [height][width] index of the nearest pixel where `is_feature` is not 0; -1 everywhere when there is none.
/// Meijster, Roerdink and Hesselink 2000, "A general algorithm for computing distance transforms in linear
/// time".
std::vector<int32_t> nearest_feature(std::span<const uint8_t> is_feature, int width, int height);

/// Between the pixels of two indices of a plane `width` px wide.
double distance_px(int64_t i, int64_t j, int width);

}  // namespace umbrameter
