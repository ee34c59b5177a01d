// SPDX-License-Identifier: Apache-2.0
#pragma once
// FLIP's filters along rows, a band of a picture at a time. Not here: along columns (metrics/flip/flip_see.h).

#include "metrics/flip/flip_filter.h"
#include "metrics/flip/flip_map.h"

#include <algorithm>
#include <array>
#include <vector>

namespace umbrameter {

/// What the columns are filtered from: the rows through every kernel that differs. Grey pictures have no chroma.
enum FlipPlane { kRedGreen, kBlueYellow0, kBlueYellow1, kLuminance, kSmooth, kEdge, kPoint, kFlipPlanes };
inline constexpr size_t kFirstOfGrey = kLuminance;

inline size_t padded(size_t count) {
  return (count + kFilterBlock - 1) / kFilterBlock * kFilterBlock;
}

/// The latest `kept` rows of every plane, row y in place of row y - kept: a whole picture's planes would cost more in
/// page faults and cache misses than the filters do.
class FilteredRows {
 public:
  FilteredRows(int width, int height, int kept, bool is_grey)
      : stride_(padded(static_cast<size_t>(width)) + kFilterBlock),
        last_(height - 1),
        kept_(kept),
        is_grey_(is_grey) {
    for (size_t plane = is_grey ? kFirstOfGrey : 0; plane < kFlipPlanes; ++plane)
      planes_[plane].resize(stride_ * static_cast<size_t>(kept));
  }
  bool is_grey() const { return is_grey_; }
  /// The row nearest to `y` that exists: outside, the border repeats.
  float* row(FlipPlane plane, int y) {
    return planes_[plane].data() + static_cast<size_t>(std::clamp(y, 0, last_) % kept_) * stride_;
  }

 private:
  size_t stride_;
  int last_, kept_;
  bool is_grey_;
  std::array<std::vector<float>, kFlipPlanes> planes_;
};

/// Filters rows y0 <= y < y1 of a picture `width` wide.
void filter_flip_rows(const FlipSource& source, const ObserverKernels& kernels, size_t width, int y0, int y1,
                      FilteredRows& out);

}  // namespace umbrameter
