// SPDX-License-Identifier: Apache-2.0
#pragma once
// Whether a map resolves a scene's shadows. Where it does not, its texels' places decide the picture, and to move them
// is no benign change.

#include "core/image.h"

#include <cstdint>
#include <optional>
#include <span>

namespace umbrameter {

/// Share of the truth's edges that the texels of `picture` do not resolve (metrics/image/texel_footprint.h). Absent without edges
/// or without texels.
std::optional<double> share_of_coarse_edges(const Image& picture, const Image& truth,
                                            std::span<const uint8_t> mask);

/// Share of the truth's shade (of 1 - R) that lies in shadows narrower than two texels of `picture`, 8-connected shapes of
/// R < .5: such a shadow is a texel wide or two by chance. 0 without texels.
double share_of_narrow_shade(const Image& picture, const Image& truth, std::span<const uint8_t> mask);

/// What of a scene's shadows a map does not resolve; shares.
struct Unresolved {
  std::optional<double> edges;  // share_of_coarse_edges
  double shade = 0.0;           // share_of_narrow_shade
};

/// At most half of the edges, and at most a tenth of the shade.
bool is_resolved(const Unresolved& unresolved);

}  // namespace umbrameter
