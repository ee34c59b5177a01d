// SPDX-License-Identifier: Apache-2.0
#include "metrics/flip/flip_rows.h"

#include "metrics/flip/flip_color.h"
#include "metrics/image/tiles.h"

namespace umbrameter {

namespace {

// A row with its border pixels repeated, and its shifted copies as the taps of a filter.
class PaddedRow {
 public:
  PaddedRow(size_t width, size_t radius)
      : width_(width), radius_(radius), values_(padded(width) + 2 * radius), taps_(2 * radius + 1) {
    for (size_t k = 0; k < taps_.size(); ++k) taps_[k] = values_.data() + k;
  }
  PaddedRow(const PaddedRow&) = delete;  // taps_ point into values_
  PaddedRow& operator=(const PaddedRow&) = delete;
  std::span<float> pixels() { return {values_.data() + radius_, width_}; }
  void repeat_border() {
    std::fill_n(values_.begin(), radius_, pixels().front());
    std::fill(values_.begin() + static_cast<std::ptrdiff_t>(radius_ + width_), values_.end(),
              pixels().back());
  }
  Taps centre() const { return taps_.data() + radius_; }

 private:
  size_t width_, radius_;
  std::vector<float> values_;
  std::vector<const float*> taps_;
};

void ycxcz_in_place(const LinearRow& row) {
  float *r = row.red.data(), *g = row.green.data(), *b = row.blue.data();
  for (size_t x = 0; x < row.red.size(); ++x) {
    const glm::vec3 color = ycxcz_from_linear({r[x], g[x], b[x]});
    r[x] = color.x;
    g[x] = color.y;
    b[x] = color.z;
  }
}

void filter_luminance(const PaddedRow& luminance, const ObserverKernels& kernels, size_t count, int y,
                      FilteredRows& out) {
  filter_even(luminance.centre(), kernels.luminance, count, out.row(kLuminance, y));
  filter_features(luminance.centre(), kernels, count, out.row(kSmooth, y), out.row(kEdge, y),
                  out.row(kPoint, y));
}

void filter_grey_row(const FlipSource& source, const ObserverKernels& kernels, size_t width, int y,
                     FilteredRows& out) {
  PaddedRow luminance(width, kernels.radius);
  source.fill(y, {luminance.pixels(), {}, {}});
  for (float& value : luminance.pixels()) value = 116.0f * value - 16.0f;
  luminance.repeat_border();
  filter_luminance(luminance, kernels, padded(width), y, out);
}

void filter_color_row(const FlipSource& source, const ObserverKernels& kernels, size_t width, int y,
                      FilteredRows& out) {
  const size_t count = padded(width);
  std::array<PaddedRow, 3> color = {PaddedRow(width, kernels.radius), PaddedRow(width, kernels.radius),
                                    PaddedRow(width, kernels.radius)};
  const LinearRow pixels = {color[0].pixels(), color[1].pixels(), color[2].pixels()};
  source.fill(y, pixels);
  ycxcz_in_place(pixels);
  for (PaddedRow& row : color) row.repeat_border();
  filter_luminance(color[0], kernels, count, y, out);
  filter_even(color[1].centre(), kernels.red_green, count, out.row(kRedGreen, y));
  filter_pair(color[2].centre(), kernels.blue_yellow_rows, count,
              {out.row(kBlueYellow0, y), out.row(kBlueYellow1, y)});
}

}  // namespace

void filter_flip_rows(const FlipSource& source, const ObserverKernels& kernels, size_t width, int y0, int y1,
                      FilteredRows& out) {
  const auto& filter_row = source.is_grey ? filter_grey_row : filter_color_row;
  for_each_row(y1 - y0, [&](int n) { filter_row(source, kernels, width, y0 + n, out); });
}

}  // namespace umbrameter
