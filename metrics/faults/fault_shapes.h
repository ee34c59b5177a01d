// SPDX-License-Identifier: Apache-2.0
#pragma once
// Shapes among wrongly shadowed pixels: which shadows have no counterpart, how wide a gap is.

#include "metrics/faults/fault_evidence.h"
#include "metrics/image/components.h"
#include "metrics/image/tiles.h"

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace umbrameter {

/// predicate(i), a small number or a truth, where a pixel is scored, 0 elsewhere.
template <class Predicate>
std::vector<uint8_t> select(const FaultInput& input, const Predicate& predicate) {
  std::vector<uint8_t> selected(input.mask.size());
  for_each_row(input.surface.height, [&](int y) {
    const size_t width = static_cast<size_t>(input.surface.width), begin = static_cast<size_t>(y) * width;
    for (size_t i = begin; i < begin + width; ++i) {
      selected[i] = input.mask[i] != 0 ? static_cast<uint8_t>(predicate(i)) : 0;
    }
  });
  return selected;
}

inline Components components_of(const FaultInput& input, std::span<const uint8_t> mask) {
  return label_components(mask, input.surface.width, input.surface.height);
}

/// 1 on the 8-connected shapes of R < .5 whose widest place is narrower than a texel and larger than a pixel: no map can draw
/// them right. Empty without any.
std::vector<uint8_t> thin_shapes(const FaultInput& input);

/// 1 on connected errors whose shade too much and shade too little are equal within a factor of two: a filter moves shade, a
/// missing caster takes it away.
std::vector<uint8_t> shade_is_kept(const FaultInput& input);

/// Why a shadow is lost: it is thinner than a texel; blurred away, so that half of its shade or more is found around it;
/// the terminator's; its blockers are in contact; or none of these.
enum class Loss : uint8_t { thin, blurred, terminator, contact, other };

/// 1 on the 8-connected shapes of R < .5 that hardly meet V < .5, lost for that reason, the first that holds. Shapes of fewer
/// than min_component_px pixels are left out. `thin` and `kept` as from thin_shapes and shade_is_kept. Empty
/// without any.
std::vector<uint8_t> lost_shapes(const FaultInput& input, std::span<const uint8_t> thin,
                                 std::span<const uint8_t> kept, Loss loss);

/// 1 on the 8-connected shapes of V < .5 that hardly meet R < .5 and are solid: a disc of extra_shadow_radius_px
/// (or a texel and a half) that fits into them, moved about, covers half of what is wrong. Acne's stripes are
/// not, and a facet that is dark from rim to rim shadows itself: it is left out, too. Empty without any.
std::vector<uint8_t> extra_shapes(const FaultInput& input);

/// The width of the widest place of each component of `gap` on the receiver, median over components.
std::optional<double> median_gap_world(const FaultInput& input, std::span<const uint8_t> gap);

}  // namespace umbrameter
