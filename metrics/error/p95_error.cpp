// SPDX-License-Identifier: Apache-2.0
#include "metrics/error/p95_error.h"

#include "metrics/image/checks.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace umbrameter {
namespace {

constexpr size_t kPixelsPerLeftOut = 20;
constexpr double kStandardErrors = 2.0;
constexpr float kLit = 0.99f;

}  // namespace

std::optional<double> measure_p95_error(const Image& test, const Image& reference,
                                        std::span<const uint8_t> mask) {
  require_same_size(test, reference, "95th percentile of the error");
  require_mask_size(reference, mask, "95th percentile of the error");
  const auto v = test.plane("visibility"), r = reference.plane("visibility"),
             se = reference.plane("visibility_se");
  std::vector<double> errors;
  for (size_t i = 0; i < mask.size(); ++i) {
    if (mask[i] == 0 || (v[i] >= kLit && r[i] >= kLit)) continue;
    const double error = std::abs(static_cast<double>(v[i]) - static_cast<double>(r[i]));
    errors.push_back(std::max(0.0, error - kStandardErrors * static_cast<double>(se[i])));
  }
  if (errors.empty()) return std::nullopt;
  const size_t rank = errors.size() - 1 - errors.size() / kPixelsPerLeftOut;
  const auto place = errors.begin() + static_cast<std::ptrdiff_t>(rank);
  std::nth_element(errors.begin(), place, errors.end());
  return *place;
}

}  // namespace umbrameter
