// SPDX-License-Identifier: Apache-2.0
#include "metrics/temporal/history.h"

#include "core/error.h"
#include "metrics/image/checks.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace umbrameter {
namespace {

constexpr double kMended = 0.9;
constexpr double kLeastMended = 1e-3;  // in visibility: less is no use of frames

/// Mean (V - A)(V - B); absent without a scored pixel.
std::optional<double> error_product(const Image& test, const Image& reference,
                                    std::span<const uint8_t> mask) {
  require_same_size(test, reference, "history");
  require_mask_size(reference, mask, "history");
  const auto v = test.plane("visibility"), a = reference.plane("half_a"), b = reference.plane("half_b");
  double sum = 0.0;
  size_t pixels = 0;
  for (size_t i = 0; i < mask.size(); ++i) {
    if (mask[i] == 0) continue;
    const double value = v[i];
    sum += (value - static_cast<double>(a[i])) * (value - static_cast<double>(b[i]));
    ++pixels;
  }
  return pixels == 0 ? std::nullopt : std::optional(sum / static_cast<double>(pixels));
}

}  // namespace

std::optional<double> measure_ghosting(const Image& test, const Image& still, const Image& reference,
                                       std::span<const uint8_t> mask) {
  const auto moved = error_product(test, reference, mask), stood = error_product(still, reference, mask);
  if (!moved || !stood) return std::nullopt;
  const double more = *moved - *stood;
  return std::copysign(std::sqrt(std::abs(more)), more);
}

std::optional<double> measure_convergence(std::span<const StillPicture> pictures, const Image& reference,
                                          std::span<const uint8_t> mask) {
  if (pictures.size() < 2)
    fail_input(fmt::format("{} pictures tell nothing of convergence", pictures.size()));
  std::vector<double> errors(pictures.size());
  for (size_t i = 0; i < errors.size(); ++i) {
    const auto product = error_product(*pictures[i].test, reference, mask);
    if (!product) return std::nullopt;
    errors[i] = std::sqrt(std::max(0.0, *product));
  }
  const double mended = errors.front() - errors.back();
  if (mended < kLeastMended) return std::nullopt;
  const double goal = errors.front() - kMended * mended;
  size_t k = 1;  // the first error is above the goal, the last is not
  while (errors[k] > goal) ++k;
  const double share = (errors[k - 1] - goal) / (errors[k - 1] - errors[k]);
  const double before = std::log(pictures[k - 1].frames), after = std::log(pictures[k].frames);
  return std::exp(before + share * (after - before));
}

}  // namespace umbrameter
