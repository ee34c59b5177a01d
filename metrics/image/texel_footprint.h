// SPDX-License-Identifier: Apache-2.0
#pragma once
// How large a shadow-map texel looks in each pixel (Lloyd 2006's m): the part of an error that only a larger
// map can mend.

#include "metrics/image/surface.h"

#include <span>
#include <vector>

namespace umbrameter {

/// How a step of one pixel moves the point's place in the map, in texels: columns are along x and along y.
struct TexelStep {
  double xx = 0.0, xy = 0.0, yx = 0.0, yy = 0.0;  // d texel.x/dx, d texel.x/dy, d texel.y/dx, d texel.y/dy
  bool known = false;
};

/// The map's coordinates of each pixel: views into an image that must outlive it; empty where the technique has
/// no single map.
struct TexelView {
  std::span<const float> x, y, width_world;
  std::span<const float> bias_world;  // empty where the technique's bias is not known

  bool known() const { return !x.empty(); }
  bool known(size_t i) const { return known() && width_world[i] > 0.0f; }
};

/// texel.x, texel.y and texel_world of `test` if it has all three, and bias_world if it has that, too. Error{input} when they are not finite at a
/// masked pixel.
TexelView checked_texels(const Image& test, std::span<const uint8_t> mask);

/// From the neighbours on the same surface; unknown where there is none along one axis.
TexelStep texel_step(const TexelView& texels, const SurfaceView& surface, size_t i);

/// The texel's longest extent in pixels; 0 when unknown or without end.
double footprint_px(const TexelStep& step);

/// Whether an edge of `width_px` is narrower than two texels larger than a pixel: no map of that size draws its width.
inline bool is_under_resolved(double texel_px, double width_px) {
  return texel_px > 1.0 && width_px < 2.0 * texel_px;
}

/// footprint_px of every masked pixel, 0 elsewhere; empty without texels.
std::vector<float> footprints_px(const TexelView& texels, const SurfaceView& surface,
                                 std::span<const uint8_t> mask);

}  // namespace umbrameter
