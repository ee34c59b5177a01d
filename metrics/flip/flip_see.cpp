// SPDX-License-Identifier: Apache-2.0
#include "metrics/flip/flip_see.h"

#include "metrics/flip/flip_color.h"
#include "metrics/flip/flip_rows.h"

#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace umbrameter {

namespace {

constexpr int kBand_px = 64;
static_assert(kFlipTile_px % kFilterBlock == 0);

// Filtering can leave the display's gamut; the paper clamps to it.
float in_gamut(float v) {
  return v < 0.0f ? 0.0f : v > 1.0f ? 1.0f : v;
}

// `convert` of every pixel's lightness, a and b.
template <class Convert>
void convert_colors(SeenRow& seen, const Convert& convert) {
  for (size_t x = 0; x < kFlipTile_px; ++x) {
    const glm::vec3 color = convert({seen.lightness[x], seen.a[x], seen.b[x]});
    seen.lightness[x] = color.x;
    seen.a[x] = color.y;
    seen.b[x] = color.z;
  }
}

void to_curve(FlipTileRow& relative) {
  for (float& value : relative) value = lab_curve(value);
}

// In three passes: a root at a time leaves the processor room to work on several pixels.
void to_lab(SeenRow& seen) {
  convert_colors(seen, [](const glm::vec3& ycxcz) {
    const glm::vec3 linear = linear_from_ycxcz(ycxcz);
    return kRelativeFromLinear * glm::vec3{in_gamut(linear.x), in_gamut(linear.y), in_gamut(linear.z)};
  });
  for (FlipTileRow* plane : {&seen.lightness, &seen.a, &seen.b}) to_curve(*plane);
  convert_colors(seen, [](const glm::vec3& curved) { return hunt_lab_from_curved(curved); });
}

void to_lightness(FlipTileRow& luminance) {
  for (float& y : luminance) y = in_gamut((y + 16.0f) * (1.0f / 116.0f));
  to_curve(luminance);
  for (float& y : luminance) y = 116.0f * y - 16.0f;
}

// Both derivatives are of (Y + 16) / 116, in which white is 1.
void to_magnitude(FlipTileRow& along, const FlipTileRow& across) {
  for (size_t x = 0; x < kFlipTile_px; ++x) {
    along[x] = std::sqrt(along[x] * along[x] + across[x] * across[x]) * (1.0f / 116.0f);
  }
}

class ColumnFilter {
 public:
  ColumnFilter(FilteredRows& rows, const ObserverKernels& kernels)
      : rows_(rows), kernels_(kernels), taps_(2 * kernels.radius + 1) {}

  void see(SeenRow& out) {
    x_ = out.x;
    y_ = static_cast<int>(out.y);
    const size_t count = padded(out.count);
    filter_even(centre(kLuminance), kernels_.luminance, count, out.lightness.data());
    if (rows_.is_grey()) {
      to_lightness(out.lightness);
    } else {
      filter_even(centre(kRedGreen), kernels_.red_green, count, out.a.data());
      FlipTileRow more{};
      filter_even(centre(kBlueYellow0), kernels_.blue_yellow_columns[0], count, out.b.data());
      filter_even(centre(kBlueYellow1), kernels_.blue_yellow_columns[1], count, more.data());
      for (size_t x = 0; x < kFlipTile_px; ++x) out.b[x] += more[x];
      to_lab(out);
    }
    FlipTileRow across_edge{}, across_point{};
    filter_even(centre(kEdge), kernels_.smooth, count, out.edge.data());
    filter_even(centre(kPoint), kernels_.smooth, count, out.point.data());
    filter_derivatives(centre(kSmooth), kernels_, count, across_edge.data(), across_point.data());
    to_magnitude(out.edge, across_edge);
    to_magnitude(out.point, across_point);
  }

 private:
  Taps centre(FlipPlane plane) {
    const int radius = static_cast<int>(kernels_.radius);
    const int taps = 2 * radius + 1;
    for (int tap = 0; tap < taps; ++tap)
      taps_[static_cast<size_t>(tap)] = rows_.row(plane, y_ + tap - radius) + x_;
    return taps_.data() + radius;
  }

  FilteredRows& rows_;
  const ObserverKernels& kernels_;
  size_t x_ = 0;
  int y_ = 0;
  std::vector<const float*> taps_;
};

}  // namespace

void see_rows(const FlipSource& picture, int width, int height, double ppd,
              const std::function<void(const SeenRow&)>& visit) {
  const ObserverKernels kernels = observer_kernels(ppd);
  const int radius = static_cast<int>(kernels.radius);
  const size_t columns = static_cast<size_t>(width);
  FilteredRows rows(width, height, kBand_px + 2 * radius, picture.is_grey);
  int filtered = 0;  // rows so far
  for (int y0 = 0; y0 < height; y0 += kBand_px) {
    const int y1 = std::min(y0 + kBand_px, height), needed = std::min(y1 + radius, height);
    filter_flip_rows(picture, kernels, columns, filtered, needed, rows);
    filtered = needed;
    tbb::parallel_for(0, (width + kFlipTile_px - 1) / kFlipTile_px, [&](int tile) {
      ColumnFilter filter(rows, kernels);
      SeenRow seen{};
      seen.x = static_cast<size_t>(tile) * kFlipTile_px;
      seen.count = std::min(columns - seen.x, size_t{kFlipTile_px});
      for (int y = y0; y < y1; ++y) {
        seen.y = static_cast<size_t>(y);
        filter.see(seen);
        visit(seen);
      }
    });
  }
}

}  // namespace umbrameter
