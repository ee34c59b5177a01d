// SPDX-License-Identifier: Apache-2.0
#include "results/bench/truth_curve.h"

#include <cmath>

namespace umbrameter {

std::optional<double> convergence_exponent(std::span<const TruthPoint> points) {
  double n = 0.0, x = 0.0, y = 0.0, xx = 0.0, xy = 0.0;
  for (const TruthPoint& point : points) {
    if (point.kind != "samples" || !point.rmse || !(point.rmse->value > 0.0)) continue;
    const double lx = std::log(point.setting), ly = std::log(point.rmse->value);
    n += 1.0;
    x += lx;
    y += ly;
    xx += lx * lx;
    xy += lx * ly;
  }
  if (n < 2.0) return std::nullopt;
  return (n * xy - x * y) / (n * xx - x * x);
}

}  // namespace umbrameter
