// SPDX-License-Identifier: Apache-2.0
#include "metrics/image/separable_filter.h"

#include "metrics/image/tiles.h"

#include <cmath>

namespace umbrameter {

namespace {

// One addend at a time over a whole row: the inner loop vectorises, and the order of summation is fixed.
void add_scaled(const float* from, float weight, size_t count, float* to) {
  for (size_t x = 0; x < count; ++x) to[x] += weight * from[x];
}

}  // namespace

Kernel gaussian_kernel(double sigma_px, int radius_px) {
  std::vector<double> weights;
  double sum = 0.0;
  for (int k = -radius_px; k <= radius_px; ++k) {
    weights.push_back(std::exp(-0.5 * k * k / (sigma_px * sigma_px)));
    sum += weights.back();
  }
  Kernel kernel;
  for (const double weight : weights) kernel.weights.push_back(static_cast<float>(weight / sum));
  return kernel;
}

std::vector<float> filter_rows(std::span<const float> plane, int width, int height, const Kernel& kernel) {
  std::vector<float> out(plane.size(), 0.0f);
  const size_t columns = static_cast<size_t>(width), radius = static_cast<size_t>(kernel.radius());
  for_each_row(height, [&](int y) {
    const std::span<const float> row = plane.subspan(static_cast<size_t>(y) * columns, columns);
    std::vector<float> padded(columns + 2 * radius);
    std::fill_n(padded.begin(), radius, row.front());
    std::copy(row.begin(), row.end(), padded.begin() + static_cast<std::ptrdiff_t>(radius));
    std::fill_n(padded.end() - static_cast<std::ptrdiff_t>(radius), radius, row.back());
    float* to = out.data() + static_cast<size_t>(y) * columns;
    for (size_t k = 0; k < kernel.weights.size(); ++k)
      add_scaled(padded.data() + k, kernel.weights[k], columns, to);
  });
  return out;
}

std::vector<float> filter_columns(std::span<const float> plane, int width, int height, const Kernel& kernel) {
  std::vector<float> out(plane.size(), 0.0f);
  const size_t columns = static_cast<size_t>(width);
  for_each_row(height, [&](int y) {
    float* to = out.data() + static_cast<size_t>(y) * columns;
    for (int k = -kernel.radius(); k <= kernel.radius(); ++k) {
      const size_t from = static_cast<size_t>(std::clamp(y + k, 0, height - 1)) * columns;
      add_scaled(plane.data() + from, kernel.weights[static_cast<size_t>(k + kernel.radius())], columns, to);
    }
  });
  return out;
}

std::vector<float> filter(std::span<const float> plane, int width, int height, const Kernel& along_rows,
                          const Kernel& along_columns) {
  return filter_columns(filter_rows(plane, width, height, along_rows), width, height, along_columns);
}

}  // namespace umbrameter
