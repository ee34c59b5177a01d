// SPDX-License-Identifier: Apache-2.0
#pragma once
// Faults painted into pictures: which pixels are wrong is then known.

#include "core/image.h"

#include <cstdint>
#include <span>
#include <vector>

namespace umbrameter {

/// A picture with a fault, and where it was painted; nothing is painted where a scene has no place for it.
struct Injected {
  Image picture;
  std::vector<uint8_t> pixels;  // [height][width]
  size_t count() const;
};

/// `picture` is of the scene that `truth` is of; `mask` its scored pixels.
struct Canvas {
  const Image& picture;
  const Image& truth;
  std::span<const uint8_t> mask;
};

/// Full light in three columns, as far as they lie in the umbra away from contacts.
Injected light_leak_slit(const Canvas& canvas);
/// Half dark in .2 % of the fully lit pixels.
Injected speckle(const Canvas& canvas);
/// Stripes a quarter dark in the middle half of the picture, where it is fully lit.
Injected stripes(const Canvas& canvas);
/// The same two, 24 px or more from anything less than fully lit: beyond what widths of penumbrae excuse. Speckle is five
/// times as dense, to have enough of it.
Injected speckle_in_the_open(const Canvas& canvas);
Injected stripes_in_the_open(const Canvas& canvas);
/// Full light in the shadow next to contacts.
Injected contact_gap(const Canvas& canvas);
/// .15 more light in the umbra of two blockers or more.
Injected bleeding(const Canvas& canvas);
/// A box of 11 px over the whole picture, twice: over outlines, too.
Injected picture_blur(const Canvas& canvas);
/// Full light where a smooth mesh's own facets hide the light that only just reaches its smooth normal.
Injected terminator_cured(const Canvas& canvas);
/// Every value moved by -1, 0 or 1 of 255.
Injected jitter(const Canvas& canvas);

}  // namespace umbrameter
