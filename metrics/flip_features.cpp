#include "metrics/flip_features.h"

#include "metrics/separable_filter.h"

#include <cmath>

namespace umbrameter {

namespace {

constexpr double kFeatureWidthDeg = 0.082;

// Positive weights add up to 1, negative ones to -1.
Kernel balanced(std::vector<double> weights) {
  double positive = 0.0, negative = 0.0;
  for (const double w : weights) (w > 0.0 ? positive : negative) += std::abs(w);
  Kernel kernel;
  for (const double w : weights)
    kernel.weights.push_back(static_cast<float>(w / (w > 0.0 ? positive : negative)));
  return kernel;
}

std::vector<float> magnitude(std::vector<float> x, const std::vector<float>& y) {
  for (size_t i = 0; i < x.size(); ++i) x[i] = std::sqrt(x[i] * x[i] + y[i] * y[i]);
  return x;
}

}  // namespace

Features find_features(std::span<const float> achromatic, int width, int height, double ppd) {
  const double sigma = 0.5 * kFeatureWidthDeg * ppd;
  const int radius = static_cast<int>(std::ceil(3.0 * sigma));
  std::vector<double> first, second;
  for (int k = -radius; k <= radius; ++k) {
    const double g = std::exp(-0.5 * k * k / (sigma * sigma));
    first.push_back(-k * g);
    second.push_back((k * k / (sigma * sigma) - 1.0) * g);
  }
  const Kernel smooth = gaussian_kernel(sigma, radius), edge = balanced(first), point = balanced(second);
  std::vector<float> luminance(achromatic.begin(), achromatic.end());
  for (float& value : luminance) value = (value + 16.0f) / 116.0f;

  const std::vector<float> smooth_rows = filter_rows(luminance, width, height, smooth);
  return {magnitude(filter_columns(filter_rows(luminance, width, height, edge), width, height, smooth),
                    filter_columns(smooth_rows, width, height, edge)),
          magnitude(filter_columns(filter_rows(luminance, width, height, point), width, height, smooth),
                    filter_columns(smooth_rows, width, height, point))};
}

}  // namespace umbrameter
