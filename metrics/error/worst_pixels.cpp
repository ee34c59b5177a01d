// SPDX-License-Identifier: Apache-2.0
#include "metrics/error/worst_pixels.h"

#include "metrics/image/checks.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>
#include <vector>

namespace umbrameter {
namespace {

constexpr size_t kPixelsPerWorst = 100;

}  // namespace

std::optional<double> measure_worst_pixels(const Image& test, const Image& reference,
                                           std::span<const uint8_t> mask) {
  require_same_size(test, reference, "worst pixels");
  require_mask_size(reference, mask, "worst pixels");
  const auto v = test.plane("visibility"), r = reference.plane("visibility");
  std::vector<double> squares;
  for (size_t i = 0; i < mask.size(); ++i) {
    const double error = static_cast<double>(v[i]) - static_cast<double>(r[i]);
    if (mask[i] != 0) squares.push_back(error * error);
  }
  if (squares.empty()) return std::nullopt;
  const size_t count = (squares.size() + kPixelsPerWorst - 1) / kPixelsPerWorst;
  const auto end = squares.begin() + static_cast<std::ptrdiff_t>(count);
  std::nth_element(squares.begin(), end - 1, squares.end(), std::greater<>());
  return std::sqrt(std::accumulate(squares.begin(), end, 0.0) / static_cast<double>(count));
}

}  // namespace umbrameter
