// SPDX-License-Identifier: Apache-2.0
#include "metrics/statistics/bootstrap.h"

#include "core/error.h"

#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace umbrameter {

namespace {

// SplitMix64 (Steele, Lea, Flood 2014): a stream a round, so that rounds may run in any order.
struct RandomStream {
  uint64_t state;
  uint64_t next() {
    state += 0x9e3779b97f4a7c15ull;
    uint64_t z = state;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ull;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebull;
    return z ^ (z >> 31);
  }
  // Lemire's multiply-shift; its bias of count / 2^32 is far below the bootstrap's own spread.
  size_t below(size_t count) { return static_cast<size_t>(((next() >> 32) * count) >> 32); }
};

double resampled_ratio(std::span<const TileSum> tiles, RandomStream random) {
  TileSum total;
  for (size_t i = 0; i < tiles.size(); ++i) {
    const TileSum& tile = tiles[random.below(tiles.size())];
    total.sum += tile.sum;
    total.weight += tile.weight;
  }
  return total.sum / total.weight;
}

double quantile_of_sorted(std::span<const double> sorted, double q) {
  const double at = std::clamp(q, 0.0, 1.0) * static_cast<double>(sorted.size() - 1);
  const size_t below = static_cast<size_t>(at);
  const size_t above = std::min(below + 1, sorted.size() - 1);
  return std::lerp(sorted[below], sorted[above], at - static_cast<double>(below));
}

}  // namespace

double student_t_975(int degrees) {
  UMBRAMETER_ASSERT(degrees >= 1, "{} degrees of freedom", degrees);
  constexpr std::array<double, 10> kSmall = {12.7062, 4.3027, 3.1824, 2.7764, 2.5706,
                                             2.4469,  2.3646, 2.3060, 2.2622, 2.2281};
  if (degrees <= static_cast<int>(kSmall.size())) return kSmall[static_cast<size_t>(degrees - 1)];
  // Cornish-Fisher expansion (Abramowitz and Stegun 26.7.5) about the normal quantile; within 1e-3 from 10
  // on.
  const double z = 1.959964;
  const double n = degrees;
  return z + (std::pow(z, 3) + z) / (4.0 * n) +
         (5.0 * std::pow(z, 5) + 16.0 * std::pow(z, 3) + 3.0 * z) / (96.0 * n * n);
}

std::optional<BootstrapInterval> bootstrap_ratio(std::span<const TileSum> tiles, int rounds, uint64_t seed) {
  std::vector<TileSum> used;
  std::copy_if(tiles.begin(), tiles.end(), std::back_inserter(used),
               [](const TileSum& tile) { return tile.weight > 0.0; });
  if (used.size() < 2) return std::nullopt;
  if (rounds < 100) fail_input(fmt::format("bootstrap_rounds is {}", rounds), {}, "at least 100");

  std::vector<double> ratios(static_cast<size_t>(rounds));
  tbb::parallel_for(size_t{0}, ratios.size(), [&](size_t round) {
    RandomStream random{seed};
    random.state = random.next() ^ (round * 0xd1342543de82ef95ull);
    ratios[round] = resampled_ratio(used, random);
  });
  std::sort(ratios.begin(), ratios.end());

  // A bootstrap's spread is sqrt((n-1)/n) of the true one and normal rather than t: take it out of the tail.
  const double n = static_cast<double>(used.size());
  const double z = std::sqrt(n / (n - 1.0)) * student_t_975(static_cast<int>(used.size()) - 1);
  const double tail = 0.5 * std::erfc(z / std::sqrt(2.0));
  return BootstrapInterval{quantile_of_sorted(ratios, tail), quantile_of_sorted(ratios, 1.0 - tail)};
}

}  // namespace umbrameter
