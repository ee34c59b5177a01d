#include "metrics/flip_map.h"

#include "metrics/flip_color.h"
#include "metrics/flip_filter.h"
#include "metrics/tiles.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace umbrameter {

namespace {

// The paper's constants: colour exponent .7 (see color_difference), knee of the colour curve.
constexpr float kKneeAt = 0.4f, kKneeValue = 0.95f;

// What the columns of an image are filtered from: its rows through the kernels that differ.
enum Plane { kLuminance, kRedGreen, kBlueYellow0, kBlueYellow1, kSmooth, kEdge, kPoint, kPlanes };

constexpr int kTile_px = 128;  // columns worked on together: what they need stays in the second cache
constexpr int kBand_px = 64;
using TileRow = std::array<float, kTile_px>;
static_assert(kTile_px % kFilterBlock == 0);

size_t padded(size_t count) {
  return (count + kFilterBlock - 1) / kFilterBlock * kFilterBlock;
}

// The latest `kept` rows of every plane, row y in place of row y - kept: a whole picture's planes would cost more in
// page faults and cache misses than the filters do.
class FilteredRows {
 public:
  FilteredRows(int width, int height, int kept)
      : stride_(padded(static_cast<size_t>(width)) + kFilterBlock), last_(height - 1), kept_(kept) {
    for (auto& plane : planes_) plane.resize(stride_ * static_cast<size_t>(kept));
  }
  /// The row nearest to `y` that exists: outside, the border repeats.
  float* row(Plane plane, int y) {
    return planes_[plane].data() + static_cast<size_t>(std::clamp(y, 0, last_) % kept_) * stride_;
  }

 private:
  size_t stride_;
  int last_, kept_;
  std::array<std::vector<float>, kPlanes> planes_;
};

// A row with its border pixels repeated, and its shifted copies as the taps of a filter.
class PaddedRow {
 public:
  PaddedRow(size_t width, size_t radius)
      : width_(width), radius_(radius), values_(padded(width) + 2 * radius), taps_(2 * radius + 1) {
    for (size_t k = 0; k < taps_.size(); ++k) taps_[k] = values_.data() + k;
  }
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

// Rows y0 <= y < y1 of a picture `width` wide.
void filter_rows(const RowSource& source, const ObserverKernels& kernels, size_t width, int y0, int y1,
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
    for (int plane = 0; plane < kPlanes; ++plane)
      std::fill_n(out.row(static_cast<Plane>(plane), y), count, 0.0f);
    add_even(color[0].centre(), kernels.luminance, count, out.row(kLuminance, y));
    add_even(color[1].centre(), kernels.red_green, count, out.row(kRedGreen, y));
    add_even(color[2].centre(), kernels.blue_yellow_rows[0], count, out.row(kBlueYellow0, y));
    add_even(color[2].centre(), kernels.blue_yellow_rows[1], count, out.row(kBlueYellow1, y));
    add_even(color[0].centre(), kernels.smooth, count, out.row(kSmooth, y));
    add_odd(color[0].centre(), kernels.edge, count, out.row(kEdge, y));
    add_even(color[0].centre(), kernels.point, count, out.row(kPoint, y));
  });
}

// What the observer sees of one image along a row of a tile.
struct SeenRow {
  TileRow lightness, a, b;  // CIELab with the Hunt effect
  TileRow edge, point;      // magnitudes
};

void to_lab(SeenRow& seen) {
  for (size_t x = 0; x < kTile_px; ++x) {
    const glm::vec3 linear = linear_from_ycxcz({seen.lightness[x], seen.a[x], seen.b[x]});
    // Filtering can leave the display's gamut; the paper clamps to it.
    const auto clamped = [](float v) { return v < 0.0f ? 0.0f : v > 1.0f ? 1.0f : v; };
    const glm::vec3 lab = hunt_lab_from_linear({clamped(linear.x), clamped(linear.y), clamped(linear.z)});
    seen.lightness[x] = lab.x;
    seen.a[x] = lab.y;
    seen.b[x] = lab.z;
  }
}

// Both derivatives are of (Y + 16) / 116, in which white is 1.
void to_magnitude(TileRow& along, const TileRow& across) {
  for (size_t x = 0; x < kTile_px; ++x) {
    along[x] = std::sqrt(along[x] * along[x] + across[x] * across[x]) * (1.0f / 116.0f);
  }
}

class ColumnFilter {
 public:
  ColumnFilter(FilteredRows& rows, const ObserverKernels& kernels, int x0, int y, size_t count)
      : rows_(rows), kernels_(kernels), x0_(x0), y_(y), count_(count), taps_(2 * kernels.radius + 1) {}

  void see(SeenRow& out) {
    out = {};
    TileRow across_edge{}, across_point{};
    add_even(centre(kLuminance), kernels_.luminance, count_, out.lightness.data());
    add_even(centre(kRedGreen), kernels_.red_green, count_, out.a.data());
    add_even(centre(kBlueYellow0), kernels_.blue_yellow_columns[0], count_, out.b.data());
    add_even(centre(kBlueYellow1), kernels_.blue_yellow_columns[1], count_, out.b.data());
    add_even(centre(kEdge), kernels_.smooth, count_, out.edge.data());
    add_even(centre(kPoint), kernels_.smooth, count_, out.point.data());
    add_odd(centre(kSmooth), kernels_.edge, count_, across_edge.data());
    add_even(centre(kSmooth), kernels_.point, count_, across_point.data());
    to_lab(out);
    to_magnitude(out.edge, across_edge);
    to_magnitude(out.point, across_point);
  }

 private:
  const float* const* centre(Plane plane) {
    const int radius = static_cast<int>(kernels_.radius);
    for (int k = -radius; k <= radius; ++k)
      taps_[static_cast<size_t>(k + radius)] = rows_.row(plane, y_ + k) + x0_;
    return taps_.data() + radius;
  }

  FilteredRows& rows_;
  const ObserverKernels& kernels_;
  int x0_, y_;
  size_t count_;
  std::vector<const float*> taps_;
};

float powered_hyab(const glm::vec3& a, const glm::vec3& b) {
  const float fifth = root<5>(hyab_distance(a, b));
  return fifth * fifth * fifth * std::sqrt(fifth);  // the power .7
}

// The largest difference a display can show: green against blue.
float largest_color_difference() {
  return powered_hyab(hunt_lab_from_linear({0.0f, 1.0f, 0.0f}), hunt_lab_from_linear({0.0f, 0.0f, 1.0f}));
}

// Compresses differences above the knee: what is very different cannot become much more so.
float color_difference(const glm::vec3& a, const glm::vec3& b, float largest) {
  const float difference = powered_hyab(a, b), knee = kKneeAt * largest;
  const float below = difference * (kKneeValue / knee);
  const float above = kKneeValue + (difference - knee) * ((1.0f - kKneeValue) / (largest - knee));
  return difference < knee ? below : above;
}

void compare_tile_row(FilteredRows& rows_a, FilteredRows& rows_b, const ObserverKernels& kernels, int x0,
                      int y, size_t count, float* map) {
  static const float largest = largest_color_difference();
  SeenRow a, b;
  ColumnFilter(rows_a, kernels, x0, y, padded(count)).see(a);
  ColumnFilter(rows_b, kernels, x0, y, padded(count)).see(b);
  TileRow flip;
  for (size_t x = 0; x < kTile_px; ++x) {
    const float color =
        color_difference({a.lightness[x], a.a[x], a.b[x]}, {b.lightness[x], b.a[x], b.b[x]}, largest);
    const float edge = std::abs(a.edge[x] - b.edge[x]), point = std::abs(a.point[x] - b.point[x]);
    const float feature = std::sqrt((edge > point ? edge : point) * (1.0f / std::numbers::sqrt2_v<float>));
    flip[x] = fast_pow(color, 1.0f - (feature < 1.0f ? feature : 1.0f));
  }
  std::copy_n(flip.begin(), count, map);
}

}  // namespace

std::vector<float> flip_map(const RowSource& test, const RowSource& reference, int width, int height,
                            double ppd) {
  const ObserverKernels kernels = observer_kernels(ppd);
  const int radius = static_cast<int>(kernels.radius), kept = kBand_px + 2 * radius;
  const size_t columns = static_cast<size_t>(width);
  FilteredRows rows_a(width, height, kept), rows_b(width, height, kept);
  std::vector<float> map(columns * static_cast<size_t>(height));
  int filtered = 0;  // rows so far
  for (int y0 = 0; y0 < height; y0 += kBand_px) {
    const int y1 = std::min(y0 + kBand_px, height), needed = std::min(y1 + radius, height);
    filter_rows(test, kernels, columns, filtered, needed, rows_a);
    filter_rows(reference, kernels, columns, filtered, needed, rows_b);
    filtered = needed;
    tbb::parallel_for(0, (width + kTile_px - 1) / kTile_px, [&](int tile) {
      const int x0 = tile * kTile_px;
      for (int y = y0; y < y1; ++y) {
        compare_tile_row(rows_a, rows_b, kernels, x0, y,
                         std::min(columns - static_cast<size_t>(x0), size_t{kTile_px}),
                         map.data() + static_cast<size_t>(y) * columns + static_cast<size_t>(x0));
      }
    });
  }
  return map;
}

}  // namespace umbrameter
