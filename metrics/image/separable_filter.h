// SPDX-License-Identifier: Apache-2.0
#pragma once
// Convolution of a plane with a one-dimensional kernel along rows or columns; the border pixel repeats
// outside.

#include <span>
#include <vector>

namespace umbrameter {

/// weights[radius + k] meets the pixel k to the right or below.
struct Kernel {
  std::vector<float> weights;
  int radius() const { return static_cast<int>(weights.size() / 2); }
};

/// exp(-x^2 / (2 sigma^2)) over -radius..radius; the weights add up to 1.
Kernel gaussian_kernel(double sigma_px, int radius_px);

std::vector<float> filter_rows(std::span<const float> plane, int width, int height, const Kernel& kernel);
std::vector<float> filter_columns(std::span<const float> plane, int width, int height, const Kernel& kernel);
/// Along rows with the first, then along columns with the second.
std::vector<float> filter(std::span<const float> plane, int width, int height, const Kernel& along_rows,
                          const Kernel& along_columns);

}  // namespace umbrameter
