#include "metrics/flip_map.h"

#include "metrics/flip_color.h"
#include "metrics/flip_rows.h"

#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace umbrameter {

namespace {

// The paper's constants: colour exponent .7 (see color_difference), knee of the colour curve.
constexpr float kKneeAt = 0.4f, kKneeValue = 0.95f;

constexpr int kTile_px = 128;  // columns worked on together: what they need stays in the second cache
constexpr int kBand_px = 64;
using TileRow = std::array<float, kTile_px>;
static_assert(kTile_px % kFilterBlock == 0);

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
  const float* const* centre(FlipPlane plane) {
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
    filter_flip_rows(test, kernels, columns, filtered, needed, rows_a);
    filter_flip_rows(reference, kernels, columns, filtered, needed, rows_b);
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
