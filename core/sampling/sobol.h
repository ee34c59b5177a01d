// SPDX-License-Identifier: Apache-2.0
#pragma once
// Owen-scrambled Sobol points in two dimensions.

#include <glm/vec2.hpp>

#include <cstdint>

namespace umbrameter {

/// First two Sobol dimensions of `index` as 32-bit fractions (van der Corput, and Joe-Kuo dimension 2).
struct SobolPoint {
  uint32_t x = 0;
  uint32_t y = 0;
};
SobolPoint sobol_point(uint32_t index);

/// Nested uniform (Owen) scrambling of a 32-bit fraction by hashing: Laine-Karras permutation on reversed
/// bits. Source: Burley, "Practical Hash-based Owen Scrambling", JCGT 9(4), 2020.
uint32_t owen_scramble(uint32_t fraction, uint32_t seed);

/// A good 32-bit mix of `value` and `seed`; equal inputs give equal outputs, neighbours differ everywhere.
uint32_t hash_combine(uint32_t seed, uint32_t value);

/// Point `index` of the set scrambled by `seed`, in [0,1)^2. Any 2^k consecutive aligned points are
/// stratified.
glm::vec2 scrambled_sobol(uint32_t index, uint32_t seed);

}  // namespace umbrameter
