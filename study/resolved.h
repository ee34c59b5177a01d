// SPDX-License-Identifier: Apache-2.0
#pragma once
// Whether a map resolves a scene's shadows. Where it does not, its texels' places decide the picture, and to move them
// is no benign change.

#include "core/image.h"

#include <cstdint>
#include <optional>
#include <span>

namespace umbrameter {

/// Share of the truth's edges that the texels of `picture` do not resolve (metrics/texel_footprint.h). Absent without edges
/// or without texels.
std::optional<double> share_of_coarse_edges(const Image& picture, const Image& truth,
                                            std::span<const uint8_t> mask);

/// At most half of them are coarse.
bool is_resolved(const std::optional<double>& coarse_edges);

}  // namespace umbrameter
