#include "metrics/flip_rows.h"

#include "metrics/flip_color.h"
#include "metrics/tiles.h"

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
  const float* const* centre() const { return taps_.data() + radius_; }

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

}  // namespace

void filter_flip_rows(const RowSource& source, const ObserverKernels& kernels, size_t width, int y0, int y1,
                      FilteredRows& out) {
  const size_t count = padded(width);
  for_each_row(y1 - y0, [&](int n) {
    const int y = y0 + n;
    std::array<PaddedRow, 3> color = {PaddedRow(width, kernels.radius), PaddedRow(width, kernels.radius),
                                      PaddedRow(width, kernels.radius)};
    const LinearRow pixels = {color[0].pixels(), color[1].pixels(), color[2].pixels()};
    source(y, pixels);
    ycxcz_in_place(pixels);
    for (PaddedRow& row : color) row.repeat_border();
    for (int plane = 0; plane < kFlipPlanes; ++plane)
      std::fill_n(out.row(static_cast<FlipPlane>(plane), y), count, 0.0f);
    add_even(color[0].centre(), kernels.luminance, count, out.row(kLuminance, y));
    add_even(color[1].centre(), kernels.red_green, count, out.row(kRedGreen, y));
    add_even(color[2].centre(), kernels.blue_yellow_rows[0], count, out.row(kBlueYellow0, y));
    add_even(color[2].centre(), kernels.blue_yellow_rows[1], count, out.row(kBlueYellow1, y));
    add_even(color[0].centre(), kernels.smooth, count, out.row(kSmooth, y));
    add_odd(color[0].centre(), kernels.edge, count, out.row(kEdge, y));
    add_even(color[0].centre(), kernels.point, count, out.row(kPoint, y));
  });
}

}  // namespace umbrameter
