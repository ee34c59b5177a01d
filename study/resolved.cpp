// SPDX-License-Identifier: Apache-2.0
#include "study/resolved.h"

#include "metrics/penumbra.h"
#include "metrics/surface.h"
#include "metrics/texel_footprint.h"

namespace umbrameter {

namespace {

constexpr double kMostCoarse = 0.5;

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

bool is_resolved(const std::optional<double>& coarse_edges) {
  return !coarse_edges || *coarse_edges <= kMostCoarse;
}

}  // namespace umbrameter
