// SPDX-License-Identifier: Apache-2.0
#include "core/sampling/sobol.h"

namespace umbrameter {

namespace {

uint32_t reverse_bits(uint32_t v) {
  v = (v >> 16) | (v << 16);
  v = ((v & 0xff00ff00u) >> 8) | ((v & 0x00ff00ffu) << 8);
  v = ((v & 0xf0f0f0f0u) >> 4) | ((v & 0x0f0f0f0fu) << 4);
  v = ((v & 0xccccccccu) >> 2) | ((v & 0x33333333u) << 2);
  v = ((v & 0xaaaaaaaau) >> 1) | ((v & 0x55555555u) << 1);
  return v;
}

/// Each output bit depends only on lower input bits; constants by the search of Burley 2020, listing 2.
uint32_t laine_karras_permutation(uint32_t v, uint32_t seed) {
  v += seed;
  v ^= v * 0x6c50b47cu;
  v ^= v * 0xb82f1e52u;
  v ^= v * 0xc7afe638u;
  v ^= v * 0x8d22f6e6u;
  return v;
}

/// The largest float below 1 keeps results inside [0,1) after rounding.
float unit_float(uint32_t fraction) {
  constexpr float kBelowOne = 0x1.fffffep-1f;
  const float value = static_cast<float>(fraction) * 0x1p-32f;
  return value < kBelowOne ? value : kBelowOne;
}

}  // namespace

SobolPoint sobol_point(uint32_t index) {
  // Second dimension: direction numbers of the primitive polynomial x + 1 (Joe and Kuo), v_k = v_{k-1} ^
  // v_{k-1}/2.
  uint32_t y = 0;
  for (uint32_t bits = index, direction = 1u << 31; bits != 0; bits >>= 1, direction ^= direction >> 1) {
    if (bits & 1u) y ^= direction;
  }
  return {reverse_bits(index), y};
}

uint32_t owen_scramble(uint32_t fraction, uint32_t seed) {
  return reverse_bits(laine_karras_permutation(reverse_bits(fraction), seed));
}

uint32_t hash_combine(uint32_t seed, uint32_t value) {
  // Murmur3's finaliser over a golden-ratio combination.
  uint32_t h = seed ^ (value + 0x9e3779b9u + (seed << 6) + (seed >> 2));
  h ^= h >> 16;
  h *= 0x85ebca6bu;
  h ^= h >> 13;
  h *= 0xc2b2ae35u;
  h ^= h >> 16;
  return h;
}

glm::vec2 scrambled_sobol(uint32_t index, uint32_t seed) {
  // Shuffling the index as well decorrelates the sets of different seeds (Burley 2020, section 3.2).
  const SobolPoint p = sobol_point(owen_scramble(index, hash_combine(seed, 0)));
  return {unit_float(owen_scramble(p.x, hash_combine(seed, 1))),
          unit_float(owen_scramble(p.y, hash_combine(seed, 2)))};
}

}  // namespace umbrameter
