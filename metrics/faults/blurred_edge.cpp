// SPDX-License-Identifier: Apache-2.0
#include "metrics/faults/blurred_edge.h"

#include "metrics/image/separable_filter.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace umbrameter {

namespace {

constexpr float kRise = 0.1f;         // as for standing alone
constexpr float kDarkest = 0.1f;      // at the true edge; a shadow that only moved is full or gone there
constexpr float kSurestDark = 0.25f;  // where the far side cannot be seen
constexpr int kBehind = 2;            // times the way to the edge, to look for the other error
constexpr int kLongestPx = 256;       // of a way
constexpr double kProbe_px = 3.0;
constexpr double kHopeless = 0.85;  // left by the probe: of a blur below 1.6 or above 20 px
constexpr double kSigmasReach = 3.0;
constexpr double kLeftOver = 0.35;  // of the mean |V - R|
constexpr double kLeastError = 1e-3;

/// The straight way from `i` through `edge` and on.
struct Way {
  int width = 0, height = 0;
  int x = 0, y = 0, dx = 0, dy = 0, steps = 0;

  Way(const SurfaceView& surface, size_t i, size_t edge)
      : width(surface.width),
        height(surface.height),
        x(static_cast<int>(i % static_cast<size_t>(width))),
        y(static_cast<int>(i / static_cast<size_t>(width))),
        dx(static_cast<int>(edge % static_cast<size_t>(width)) - x),
        dy(static_cast<int>(edge / static_cast<size_t>(width)) - y),
        steps(std::max(std::abs(dx), std::abs(dy))) {}

  /// Pixel after `step` steps; absent outside the picture.
  std::optional<size_t> at(int step) const {
    const double t = static_cast<double>(step) / steps;
    const int to_x = x + static_cast<int>(std::lround(t * dx)),
              to_y = y + static_cast<int>(std::lround(t * dy));
    if (to_x < 0 || to_x >= width || to_y < 0 || to_y >= height) return std::nullopt;
    return static_cast<size_t>(to_y) * static_cast<size_t>(width) + static_cast<size_t>(to_x);
  }
};

/// What is compared, and what is blurred for it.
struct Scored {
  std::span<const float> v;
  std::span<const uint8_t> mask;
  std::vector<float> weight, weighted;
  int width = 0, height = 0;
  double error = 0.0, pixels = 0.0;

  Scored(std::span<const float> test, std::span<const float> r, std::span<const uint8_t> scored,
         std::span<const uint8_t> seen, int w, int h)
      : v(test), mask(scored), weight(seen.size()), weighted(seen.size()), width(w), height(h) {
    for (size_t i = 0; i < mask.size(); ++i) {
      const bool is_seen = mask[i] != 0 || (seen[i] != 0 && r[i] >= 0.0f && r[i] <= 1.0f);
      weight[i] = is_seen ? 1.0f : 0.0f;
      weighted[i] = is_seen ? r[i] : 0.0f;
      if (mask[i] == 0) continue;
      error += std::abs(static_cast<double>(v[i]) - r[i]);
      pixels += 1.0;
    }
  }

  std::vector<float> blurred(double sigma_px) const {
    const Kernel kernel = gaussian_kernel(sigma_px, static_cast<int>(std::ceil(kSigmasReach * sigma_px)));
    std::vector<float> out = filter(weighted, width, height, kernel, kernel);
    const std::vector<float> weights = filter(weight, width, height, kernel, kernel);
    for (size_t i = 0; i < out.size(); ++i) out[i] = mask[i] != 0 ? out[i] / weights[i] : 0.0f;
    return out;
  }

  double left_by(std::span<const float> blurred) const {
    double left = 0.0;
    for (size_t i = 0; i < mask.size(); ++i) {
      if (mask[i] != 0) left += std::abs(static_cast<double>(v[i]) - blurred[i]);
    }
    return left;
  }
};

bool connected(const Outskirts& field, size_t from, std::optional<size_t> to) {
  return to && field.mask[*to] != 0 && same_surface(field.surface, from, *to);
}

}  // namespace

bool is_blurred_edge(const Outskirts& field, size_t i, size_t edge, float tolerance, bool is_kept) {
  const Way way(field.surface, i, edge);
  if (way.steps == 0 || way.steps > kLongestPx) return false;
  float lowest = field.sign * field.v[i];
  size_t from = i;
  const auto falls_to = [&](size_t to) {
    const float own = field.sign * field.v[to];
    if (own > lowest + kRise) return false;
    lowest = std::min(lowest, own);
    from = to;
    return true;
  };
  for (int step = 1; step <= way.steps; ++step) {
    const auto to = way.at(step);
    if (!connected(field, from, to) || !falls_to(*to)) return false;
  }
  const float at_edge = field.v[edge];
  const float darkest = is_kept ? std::min(tolerance, kDarkest) : kDarkest;
  if (at_edge < darkest || at_edge > 1.0f - darkest) return false;
  for (int step = way.steps + 1; step <= (1 + kBehind) * way.steps; ++step) {
    const auto to = way.at(step);
    if (!connected(field, from, to)) return at_edge >= kSurestDark && at_edge <= 1.0f - kSurestDark;
    if (!falls_to(*to)) return false;
    if (field.sign * (field.v[*to] - field.r[*to]) > tolerance) return true;
  }
  return false;
}

std::vector<float> blurred_as_picture(std::span<const float> v, std::span<const float> r,
                                      std::span<const uint8_t> mask, std::span<const uint8_t> seen, int width,
                                      int height) {
  const Scored scored(v, r, mask, seen, width, height);
  if (!(scored.error > kLeastError * scored.pixels)) return {};
  std::vector<float> best;
  double least = kLeftOver * scored.error;
  const auto attempt = [&](double sigma_px) {
    std::vector<float> blurred = scored.blurred(sigma_px);
    const double left = scored.left_by(blurred);
    if (left < least) {
      least = left;
      best = std::move(blurred);
    }
    return left / scored.error;
  };
  // Of an edge blurred by sigma a blur by another one leaves |1 - other / sigma| of the error: one attempt tells sigma.
  const double left = attempt(kProbe_px);
  if (left > kHopeless) return {};
  attempt(kProbe_px / (1.0 - left));
  attempt(kProbe_px / (1.0 + left));
  return best;
}

}  // namespace umbrameter
