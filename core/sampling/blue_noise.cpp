// SPDX-License-Identifier: Apache-2.0
#include "core/sampling/blue_noise.h"

#include "core/sampling/sobol.h"

#include <algorithm>
#include <cmath>

namespace umbrameter {
namespace {

/// What each pixel of a pattern has of marked pixels around it, in a square that repeats.
class Crowding {
 public:
  explicit Crowding(uint32_t side) : side_(side), weights_(size_t{side} * side), sums_(weights_.size(), 0) {
    constexpr double kDeviationPx = 1.5;
    constexpr double kOne = 1 << 30;
    for (uint32_t i = 0; i < weights_.size(); ++i) {
      const double x = std::min(i % side, side - i % side), y = std::min(i / side, side - i / side);
      weights_[i] = std::llround(kOne * std::exp(-(x * x + y * y) / (2.0 * kDeviationPx * kDeviationPx)));
    }
    is_marked_.assign(weights_.size(), false);
  }

  size_t size() const { return sums_.size(); }
  bool is_marked(uint32_t pixel) const { return is_marked_[pixel]; }

  void set(uint32_t pixel, bool marked) {
    is_marked_[pixel] = marked;
    const uint32_t px = pixel % side_, py = pixel / side_;
    for (uint32_t y = 0; y < side_; ++y) {
      const int64_t* row = &weights_[size_t{(y + side_ - py) % side_} * side_];
      int64_t* sums = &sums_[size_t{y} * side_];
      for (uint32_t x = 0; x < side_; ++x)
        sums[x] += marked ? row[(x + side_ - px) % side_] : -row[(x + side_ - px) % side_];
    }
  }

  uint32_t tightest_cluster() const { return extreme(true); }
  uint32_t largest_void() const { return extreme(false); }

 private:
  /// The first marked pixel with the most around it, or unmarked one with the least.
  uint32_t extreme(bool marked) const {
    uint32_t best = static_cast<uint32_t>(size());
    for (uint32_t i = 0; i < size(); ++i) {
      if (is_marked_[i] != marked) continue;
      if (best == size() || (marked ? sums_[i] > sums_[best] : sums_[i] < sums_[best])) best = i;
    }
    return best;
  }

  uint32_t side_;
  std::vector<int64_t> weights_;
  std::vector<int64_t> sums_;
  std::vector<bool> is_marked_;
};

/// A tenth of the pixels, moved from clusters into voids until that moves none.
uint32_t mark_evenly(Crowding& pattern) {
  const auto count = static_cast<uint32_t>(pattern.size() / 10);
  for (uint32_t marked = 0, i = 0; marked < count; ++i) {
    const uint32_t pixel = hash_combine(1, i) % static_cast<uint32_t>(pattern.size());
    if (pattern.is_marked(pixel)) continue;
    pattern.set(pixel, true);
    ++marked;
  }
  for (;;) {
    const uint32_t from = pattern.tightest_cluster();
    pattern.set(from, false);
    const uint32_t to = pattern.largest_void();
    pattern.set(to, true);
    if (from == to) return count;
  }
}

}  // namespace

std::vector<uint32_t> blue_noise_ranks(uint32_t side) {
  Crowding pattern(side);
  const uint32_t first = mark_evenly(pattern);
  std::vector<uint32_t> ranks(pattern.size());
  Crowding fewer = pattern;
  for (uint32_t rank = first; rank-- > 0;) {
    const uint32_t pixel = fewer.tightest_cluster();
    ranks[pixel] = rank;
    fewer.set(pixel, false);
  }
  // Past the half Ulichney asks for the tightest cluster of unmarked pixels: of marked ones that is the largest void.
  for (uint32_t rank = first; rank < ranks.size(); ++rank) {
    const uint32_t pixel = pattern.largest_void();
    ranks[pixel] = rank;
    pattern.set(pixel, true);
  }
  return ranks;
}

}  // namespace umbrameter
