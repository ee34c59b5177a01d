// SPDX-License-Identifier: Apache-2.0
#include "metrics/image/texel_footprint.h"

#include "metrics/image/checks.h"
#include "metrics/image/tiles.h"

#include <array>
#include <cmath>
#include <limits>
#include <optional>

namespace umbrameter {

namespace {

constexpr std::array kTexelChannels = {"texel.x", "texel.y", "texel_world"};

// A pixel beside `i` that shows the same surface and lies in the map, and which way it is.
struct Neighbour {
  size_t index = 0;
  double direction = 1.0;
};

std::optional<Neighbour> neighbour(const TexelView& texels, const SurfaceView& surface, size_t i,
                                   size_t stride, bool has_next, bool has_previous) {
  const auto fits = [&](size_t j) { return texels.known(j) && same_surface(surface, i, j); };
  if (has_next && fits(i + stride)) return Neighbour{i + stride, 1.0};
  if (has_previous && fits(i - stride)) return Neighbour{i - stride, -1.0};
  return std::nullopt;
}

}  // namespace

TexelView checked_texels(const Image& test, std::span<const uint8_t> mask) {
  for (const char* channel : kTexelChannels) {
    if (!test.has(channel)) return {};
  }
  constexpr float kLargest = std::numeric_limits<float>::max();
  require_range(test, "texel.x", mask, -kLargest, kLargest);
  require_range(test, "texel.y", mask, -kLargest, kLargest);
  require_range(test, "texel_world", mask, 0.0f, kLargest);
  TexelView texels = {test.plane("texel.x"), test.plane("texel.y"), test.plane("texel_world"), {}};
  if (!test.has("bias_world")) return texels;
  require_range(test, "bias_world", mask, 0.0f, kLargest);
  texels.bias_world = test.plane("bias_world");
  return texels;
}

TexelStep texel_step(const TexelView& texels, const SurfaceView& surface, size_t i) {
  if (!texels.known(i)) return {};
  const size_t width = static_cast<size_t>(surface.width), x = i % width, y = i / width;
  const auto right = neighbour(texels, surface, i, 1, x + 1 < width, x > 0);
  if (!right) return {};
  const auto below = neighbour(texels, surface, i, width, y + 1 < static_cast<size_t>(surface.height), y > 0);
  if (!below) return {};
  const auto change = [&](std::span<const float> plane, const Neighbour& to) {
    return to.direction * (static_cast<double>(plane[to.index]) - plane[i]);
  };
  return {change(texels.x, *right), change(texels.x, *below), change(texels.y, *right),
          change(texels.y, *below), true};
}

// The inverse of the step's smaller singular value.
double footprint_px(const TexelStep& step) {
  if (!step.known) return 0.0;
  const double squares = step.xx * step.xx + step.xy * step.xy + step.yx * step.yx + step.yy * step.yy;
  const double determinant = step.xx * step.yy - step.xy * step.yx;
  const double root = std::sqrt(std::max(0.0, squares * squares - 4.0 * determinant * determinant));
  // smaller^2 = (squares - root) / 2, written without the cancellation
  const double smaller = std::abs(determinant) * std::sqrt(2.0 / (squares + root));
  return smaller > 0.0 && std::isfinite(1.0 / smaller) ? 1.0 / smaller : 0.0;
}

std::vector<float> footprints_px(const TexelView& texels, const SurfaceView& surface,
                                 std::span<const uint8_t> mask) {
  if (!texels.known()) return {};
  std::vector<float> footprints(mask.size(), 0.0f);
  for_each_row(surface.height, [&](int y) {
    const size_t width = static_cast<size_t>(surface.width), begin = static_cast<size_t>(y) * width;
    for (size_t i = begin; i < begin + width; ++i) {
      if (mask[i] != 0) footprints[i] = static_cast<float>(footprint_px(texel_step(texels, surface, i)));
    }
  });
  return footprints;
}

}  // namespace umbrameter
