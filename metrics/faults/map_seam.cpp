// SPDX-License-Identifier: Apache-2.0
#include "metrics/faults/map_seam.h"

#include "metrics/image/checks.h"
#include "metrics/image/surface.h"

#include <cmath>

namespace umbrameter {
namespace {

struct MeanStep {
  double sum = 0.0;
  size_t count = 0;

  void add(double step) {
    sum += step;
    ++count;
  }
  double value() const { return sum / static_cast<double>(count); }
};

/// Steps across and beside the borders between maps.
class SeamSteps {
 public:
  SeamSteps(const Image& test, const Image& reference, std::span<const uint8_t> mask)
      : surface_(checked_surface(reference)),
        v_(test.plane("visibility")),
        r_(reference.plane("visibility")),
        map_(test.plane("map_index")),
        mask_(mask) {}

  /// Pixels `first`, `first` + `stride`, ...: a row or a column.
  void walk(size_t first, size_t stride, size_t count) {
    for (size_t k = 0; k + 1 < count; ++k) {
      const size_t i = first + k * stride;
      if (!is_pair(i, i + stride) || map_[i] == map_[i + stride]) continue;
      across_.add(step(i, i + stride));
      if (k > 0) add_beside(i - stride, i);
      if (k + 2 < count) add_beside(i + stride, i + 2 * stride);
    }
  }

  std::optional<double> excess() const {
    if (across_.count == 0 || beside_.count == 0) return std::nullopt;
    return across_.value() - beside_.value();
  }

 private:
  bool is_pair(size_t i, size_t j) const {
    return mask_[i] != 0 && mask_[j] != 0 && map_[i] >= 0.0f && map_[j] >= 0.0f &&
           same_surface(surface_, i, j);
  }
  void add_beside(size_t i, size_t j) {
    if (is_pair(i, j) && map_[i] == map_[j]) beside_.add(step(i, j));
  }
  double error(size_t i) const { return static_cast<double>(v_[i]) - static_cast<double>(r_[i]); }
  double step(size_t i, size_t j) const { return std::abs(error(j) - error(i)); }

  SurfaceView surface_;
  std::span<const float> v_, r_, map_;
  std::span<const uint8_t> mask_;
  MeanStep across_, beside_;
};

}  // namespace

std::optional<double> measure_map_seam(const Image& test, const Image& reference,
                                       std::span<const uint8_t> mask) {
  if (!test.has("map_index")) return std::nullopt;
  require_same_size(test, reference, "seams between maps");
  require_mask_size(reference, mask, "seams between maps");
  SeamSteps steps(test, reference, mask);
  const auto width = static_cast<size_t>(reference.width), height = static_cast<size_t>(reference.height);
  for (size_t y = 0; y < height; ++y) steps.walk(y * width, 1, width);
  for (size_t x = 0; x < width; ++x) steps.walk(x, width, height);
  return steps.excess();
}

}  // namespace umbrameter
