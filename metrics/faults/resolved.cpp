// SPDX-License-Identifier: Apache-2.0
#include "metrics/faults/resolved.h"

#include "metrics/image/components.h"
#include "metrics/image/surface.h"
#include "metrics/image/texel_footprint.h"
#include "metrics/penumbra/penumbra.h"

#include <glm/vec2.hpp>

#include <algorithm>
#include <cmath>
#include <vector>

namespace umbrameter {

namespace {

constexpr double kMostCoarse = 0.5;
constexpr double kMostNarrow = 0.1;
constexpr double kFewestTexels = 2.0;  // across a shadow, as across an edge

// Sums over a shape's pixels.
struct DarkShape {
  double pixels = 0.0, shade = 0.0;
  glm::dvec2 sum{0.0}, squares{0.0};  // of places in the map, in texels
  double product = 0.0;

  void add(const glm::dvec2& p_texels, double shade_here) {
    pixels += 1.0;
    shade += shade_here;
    sum += p_texels;
    squares += p_texels * p_texels;
    product += p_texels.x * p_texels.y;
  }

  // Across its longest extent: a straight strip w wide has a variance of w^2 / 12. A bent one seems wider.
  double width_texels() const {
    const glm::dvec2 mean = sum / pixels, variance = squares / pixels - mean * mean;
    const double covariance = product / pixels - mean.x * mean.y;
    const double least =
        0.5 * (variance.x + variance.y) - std::hypot(0.5 * (variance.x - variance.y), covariance);
    return std::sqrt(12.0 * std::max(0.0, least));
  }
};

}  // namespace

std::optional<double> share_of_coarse_edges(const Image& picture, const Image& truth,
                                            std::span<const uint8_t> mask) {
  const TexelView texels = checked_texels(picture, mask);
  const SurfaceView surface = checked_surface(truth);
  size_t edges = 0, coarse = 0;
  for (const PenumbraProfile& profile : measure_penumbra(truth, truth, mask).profiles) {
    const size_t i = profile.pixel(truth.width);
    const double texel_px = texels.known(i) ? footprint_px(texel_step(texels, surface, i)) : 0.0;
    if (!(texel_px > 0.0) || !(profile.reference_width_px > 0.0)) continue;
    ++edges;
    coarse += is_under_resolved(texel_px, profile.reference_width_px) ? 1 : 0;
  }
  if (edges == 0) return std::nullopt;
  return static_cast<double>(coarse) / static_cast<double>(edges);
}

double share_of_narrow_shade(const Image& picture, const Image& truth, std::span<const uint8_t> mask) {
  const TexelView texels = checked_texels(picture, mask);
  if (!texels.known()) return 0.0;
  const auto r = truth.plane("visibility");
  std::vector<uint8_t> dark(mask.size(), 0);
  double shade = 0.0;
  for (size_t i = 0; i < mask.size(); ++i) {
    if (mask[i] == 0 || !texels.known(i)) continue;
    shade += 1.0 - static_cast<double>(r[i]);
    dark[i] = r[i] < 0.5f ? 1 : 0;
  }
  const Components components = label_components(dark, truth.width, truth.height);
  std::vector<DarkShape> shapes(components.count);
  for (size_t i = 0; i < dark.size(); ++i) {
    if (dark[i] == 0) continue;
    shapes[static_cast<size_t>(components.label[i])].add({texels.x[i], texels.y[i]},
                                                         1.0 - static_cast<double>(r[i]));
  }
  double narrow = 0.0;
  for (const DarkShape& shape : shapes) narrow += shape.width_texels() < kFewestTexels ? shape.shade : 0.0;
  return shade > 0.0 ? narrow / shade : 0.0;
}

bool is_resolved(const Unresolved& unresolved) {
  return unresolved.edges.value_or(0.0) <= kMostCoarse && unresolved.shade <= kMostNarrow;
}

}  // namespace umbrameter
