#pragma once
// FLIP of two pictures in linear RGB, pixel by pixel; what LDR-FLIP and HDR-FLIP share.

#include <functional>
#include <span>
#include <vector>

namespace umbrameter {

/// Fills one row of a picture: linear red, green, blue in [0,1].
struct LinearRow {
  std::span<float> red, green, blue;
};
using RowSource = std::function<void(int y, const LinearRow& row)>;

/// [height][width] in [0,1], 0 = equal; `ppd` pixels per degree. The same bits with any number of threads.
std::vector<float> flip_map(const RowSource& test, const RowSource& reference, int width, int height,
                            double ppd);

}  // namespace umbrameter
