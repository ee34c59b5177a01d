// SPDX-License-Identifier: Apache-2.0
#pragma once
// How much a technique's own noise moves its mean squared error.

#include "core/image.h"

#include <cstdint>
#include <span>

namespace umbrameter {

/// Standard deviation of the mean squared error from seed to seed, from two pictures or more of one scene that differ in
/// their seed alone. Errors of one tile of 32 px may depend on each other, those of different tiles may not. 0 for pictures
/// that are equal, and without scored pixels.
double seed_noise_of_mse(std::span<const Image> pictures, const Image& truth, std::span<const uint8_t> mask);

}  // namespace umbrameter
