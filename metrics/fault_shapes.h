#pragma once
// Shapes among wrongly shadowed pixels: which shadows have no counterpart, how wide a gap is.

#include "metrics/components.h"
#include "metrics/fault_evidence.h"
#include "metrics/tiles.h"

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace umbrameter {

/// 1 where a pixel is scored and predicate(i).
template <class Predicate>
std::vector<uint8_t> select(const FaultInput& input, const Predicate& predicate) {
  std::vector<uint8_t> selected(input.mask.size());
  for_each_row(input.surface.height, [&](int y) {
    const size_t width = static_cast<size_t>(input.surface.width), begin = static_cast<size_t>(y) * width;
    for (size_t i = begin; i < begin + width; ++i) selected[i] = input.mask[i] != 0 && predicate(i) ? 1 : 0;
  });
  return selected;
}

inline Components components_of(const FaultInput& input, std::span<const uint8_t> mask) {
  return label_components(mask, input.surface.width, input.surface.height);
}

/// 1 on the 8-connected shapes of `dark` < .5 that hardly meet `other` < .5. The overlap is measured against
/// the shape alone, so that a neighbour's shadow merging with it in one image only does not hide it. Shapes
/// are left out when they have fewer pixels than min_component_px or an inscribed radius below
/// `min_radius_px`.
std::vector<uint8_t> unmatched_shapes(const FaultInput& input, std::span<const float> dark,
                                      std::span<const float> other, double min_radius_px);

/// The width of the widest place of each component of `gap` on the receiver, median over components.
std::optional<double> median_gap_world(const FaultInput& input, std::span<const uint8_t> gap);

}  // namespace umbrameter
