// SPDX-License-Identifier: Apache-2.0
#include "metrics/isotonic.h"

#include <cmath>

namespace umbrameter {

namespace {

struct Block {
  double sum = 0.0;
  size_t count = 0;
  double mean() const { return sum / static_cast<double>(count); }
};

double crossing(std::span<const double> position, std::span<const double> fitted, double level) {
  for (size_t i = 1; i < fitted.size(); ++i) {
    if (fitted[i] < level) continue;
    const double rise = fitted[i] - fitted[i - 1];
    const double t = rise > 0.0 ? (level - fitted[i - 1]) / rise : 0.0;
    return std::lerp(position[i - 1], position[i], t);
  }
  return position.back();
}

}  // namespace

std::vector<double> fit_nondecreasing(std::span<const double> values) {
  std::vector<Block> blocks;
  blocks.reserve(values.size());
  for (const double value : values) {
    blocks.push_back({value, 1});
    while (blocks.size() > 1 && blocks[blocks.size() - 2].mean() > blocks.back().mean()) {
      const Block last = blocks.back();
      blocks.pop_back();
      blocks.back().sum += last.sum;
      blocks.back().count += last.count;
    }
  }
  std::vector<double> fitted;
  fitted.reserve(values.size());
  for (const Block& block : blocks) fitted.insert(fitted.end(), block.count, block.mean());
  return fitted;
}

// The derivative of a piecewise linear rise is a mixture of boxes; its variance is that of the boxes' centres
// plus each box's own h^2 / 12.
std::optional<Transition> measure_transition(std::span<const double> position,
                                             std::span<const double> fitted) {
  if (fitted.size() < 2) return std::nullopt;
  const double rise = fitted.back() - fitted.front();
  if (!(rise > 0.0)) return std::nullopt;
  double mean = 0.0;
  for (size_t i = 1; i < fitted.size(); ++i) {
    mean += (fitted[i] - fitted[i - 1]) / rise * 0.5 * (position[i] + position[i - 1]);
  }
  double variance = 0.0;
  for (size_t i = 1; i < fitted.size(); ++i) {
    const double offset = 0.5 * (position[i] + position[i - 1]) - mean;
    const double step = position[i] - position[i - 1];
    variance += (fitted[i] - fitted[i - 1]) / rise * (offset * offset + step * step / 12.0);
  }
  const auto at = [&](double share) { return crossing(position, fitted, fitted.front() + share * rise); };
  return Transition{std::sqrt(12.0 * variance), at(0.9) - at(0.1), at(0.5)};
}

}  // namespace umbrameter
