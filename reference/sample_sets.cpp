// SPDX-License-Identifier: Apache-2.0
#include "reference/sample_sets.h"

#include "core/sampling/sobol.h"

#include <algorithm>

namespace umbrameter {

namespace {

uint32_t spread_bits(uint32_t v) {
  v &= 0xffffu;
  v = (v | (v << 8)) & 0x00ff00ffu;
  v = (v | (v << 4)) & 0x0f0f0f0fu;
  v = (v | (v << 2)) & 0x33333333u;
  return (v | (v << 1)) & 0x55555555u;
}

uint32_t z_order(const SobolPoint& point) {
  return (spread_bits(point.x >> 16) << 1) | spread_bits(point.y >> 16);
}

std::vector<SobolPoint> scrambled_set(uint32_t points, uint32_t seed) {
  std::vector<SobolPoint> set(points);
  for (uint32_t i = 0; i < points; ++i) {
    const SobolPoint p = sobol_point(i);
    set[i] = {owen_scramble(p.x, hash_combine(seed, 0)), owen_scramble(p.y, hash_combine(seed, 1))};
  }
  for (uint32_t begin = 0, end = kFirstRound; begin < points; begin = end, end *= 2) {
    std::sort(set.begin() + begin, set.begin() + std::min(end, points),
              [](const SobolPoint& a, const SobolPoint& b) { return z_order(a) < z_order(b); });
  }
  return set;
}

}  // namespace

SampleSets::SampleSets(uint32_t points)
    : points_(points), stride_((points + 31u) & ~15u), x_(kSets * stride_), y_(kSets * stride_) {
  for (uint32_t s = 0; s < kSets; ++s) {
    const std::vector<SobolPoint> set = scrambled_set(points, s);
    for (uint32_t i = 0; i < points; ++i) {
      x_[s * stride_ + i] = set[i].x;
      y_[s * stride_ + i] = set[i].y;
    }
  }
}

SampleStream SampleSets::stream(uint32_t seed, uint32_t replicate) const {
  const uint32_t mixed = hash_combine(seed, replicate);
  const size_t offset = static_cast<size_t>(hash_combine(mixed, 0) % kSets) * stride_;
  return {x_.data() + offset, y_.data() + offset, hash_combine(mixed, 1), hash_combine(mixed, 2)};
}

uint32_t pixel_seed(uint64_t request_seed, uint32_t pixel_index) {
  const auto low = static_cast<uint32_t>(request_seed);
  const auto high = static_cast<uint32_t>(request_seed >> 32);
  return hash_combine(hash_combine(hash_combine(0u, low), high), pixel_index);
}

}  // namespace umbrameter
