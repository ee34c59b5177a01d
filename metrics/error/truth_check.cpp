// SPDX-License-Identifier: Apache-2.0
#include "metrics/error/truth_check.h"

#include "metrics/image/checks.h"

#include <fmt/format.h>

#include <cmath>

namespace umbrameter {
namespace {

constexpr float kShadow = 0.02f, kLight = 0.98f;

bool is_partial(float visibility) {
  return visibility > kShadow && visibility < kLight;
}

}  // namespace

std::vector<std::string> truth_problems(const Image& reference, std::span<const uint8_t> mask,
                                        const TruthSettings& settings) {
  require_mask_size(reference, mask, "truth check");
  const auto r = reference.plane("visibility"), se = reference.plane("visibility_se");
  const auto a = reference.plane("half_a"), b = reference.plane("half_b");
  double differences = 0.0, variances = 0.0;
  size_t partial_pixels = 0, sharp_edges = 0;
  const size_t width = static_cast<size_t>(reference.width);
  for (size_t i = 0; i < mask.size(); ++i) {
    if (mask[i] == 0) continue;
    if (is_partial(r[i])) {
      const double difference = static_cast<double>(a[i]) - b[i];
      differences += difference * difference;
      variances += 4.0 * se[i] * se[i];
      ++partial_pixels;
    }
    const bool has_right = (i + 1) % width != 0 && mask[i + 1] != 0;
    if (has_right && std::abs(r[i] - r[i + 1]) > kLight) ++sharp_edges;
    const bool has_below = i + width < mask.size() && mask[i + width] != 0;
    if (has_below && std::abs(r[i] - r[i + width]) > kLight) ++sharp_edges;
  }
  std::vector<std::string> problems;
  const double ratio = differences / variances;
  if (partial_pixels >= settings.fewest_pixels &&
      !(ratio >= settings.least_spread_ratio && ratio <= settings.largest_spread_ratio)) {
    problems.push_back(
        fmt::format("the reference's halves differ {:.3g} times as much as its standard error says", ratio));
  }
  const double edges = static_cast<double>(sharp_edges);
  if (sharp_edges >= settings.sharp_edges &&
      static_cast<double>(partial_pixels) < settings.partial_per_edge * edges) {
    problems.push_back(
        fmt::format("the reference has {} edges between light and shadow and only {} pixels of penumbra",
                    sharp_edges, partial_pixels));
  }
  return problems;
}

}  // namespace umbrameter
