// SPDX-License-Identifier: Apache-2.0
#include "metrics/statistics/isotonic.h"

#include <algorithm>
#include <cmath>

namespace umbrameter {

namespace {

struct Block {
  double sum = 0.0;
  size_t count = 0;
  double mean() const { return sum / static_cast<double>(count); }
};

struct Crossing {
  size_t step = 0;  // between samples step - 1 and step
  double position = 0.0;
};

Crossing crossing(std::span<const double> position, std::span<const double> fitted, double level) {
  for (size_t i = 1; i < fitted.size(); ++i) {
    if (fitted[i] < level) continue;
    const double rise = fitted[i] - fitted[i - 1];
    const double t = rise > 0.0 ? std::clamp((level - fitted[i - 1]) / rise, 0.0, 1.0) : 0.0;
    return {i, std::lerp(position[i - 1], position[i], t)};
  }
  return {fitted.size() - 1, position.back()};
}

struct Moments {
  double mean = 0.0;
  double between = 0.0;  // variance of the steps' centres
  double within = 0.0;   // the steps' own
};

// visit(rise, center, extent) for the part of every step that lies between the levels.
template <class Visit>
void for_each_step(std::span<const double> position, std::span<const double> fitted, const Levels& levels,
                   const Visit& visit) {
  for (size_t i = 1; i < fitted.size(); ++i) {
    const double from = std::clamp(fitted[i - 1], levels.low, levels.high),
                 to = std::clamp(fitted[i], levels.low, levels.high);
    if (!(to > from)) continue;
    const double rise = fitted[i] - fitted[i - 1], step = position[i] - position[i - 1];
    const double begin = position[i - 1] + step * (from - fitted[i - 1]) / rise;
    const double extent = step * (to - from) / rise;
    visit(to - from, begin + 0.5 * extent, extent);
  }
}

// The derivative of a piecewise linear rise is a mixture of boxes; its variance is that of the boxes' centres
// plus each box's own h^2 / 12.
Moments moments(std::span<const double> position, std::span<const double> fitted, const Levels& levels) {
  Moments m;
  const double all = levels.high - levels.low;
  for_each_step(position, fitted, levels,
                [&](double rise, double center, double) { m.mean += rise / all * center; });
  for_each_step(position, fitted, levels, [&](double rise, double center, double extent) {
    m.between += rise / all * (center - m.mean) * (center - m.mean);
    m.within += rise / all * extent * extent / 12.0;
  });
  return m;
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

std::optional<Transition> measure_transition(std::span<const double> position, std::span<const double> fitted,
                                             const Levels& levels) {
  if (fitted.size() < 2) return std::nullopt;
  const Levels inside = {std::max(levels.low, fitted.front()), std::min(levels.high, fitted.back())};
  const double rise = inside.high - inside.low;
  if (!(rise > 0.0)) return std::nullopt;
  const Moments m = moments(position, fitted, inside);
  const Crossing low = crossing(position, fitted, inside.low + 0.1 * rise),
                 high = crossing(position, fitted, inside.low + 0.9 * rise);
  Transition out;
  out.width = std::sqrt(12.0 * (m.between + m.within));
  out.resolved_width = std::sqrt(12.0 * m.between);
  out.width_10_90 = high.position - low.position;
  out.resolved_width_10_90 = low.step == high.step ? 0.0 : out.width_10_90;
  // Few levels make plateaus, and the one at half height reaches further to one side than to the other; the mean of the
  // middle half lies in its middle.
  out.center = moments(position, fitted, {inside.low + 0.25 * rise, inside.low + 0.75 * rise}).mean;
  return out;
}

std::optional<Transition> measure_transition(std::span<const double> position,
                                             std::span<const double> fitted) {
  if (fitted.empty()) return std::nullopt;
  return measure_transition(position, fitted, {fitted.front(), fitted.back()});
}

}  // namespace umbrameter
