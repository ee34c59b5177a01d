// SPDX-License-Identifier: Apache-2.0
#pragma once
// Size, samples and seed of pictures: said once, and held by every plan, result and stored record.

#include "core/renderer.h"

#include <cstdint>
#include <optional>

namespace umbrameter {

struct PictureQuality {
  int width_px = 0;
  int height_px = 0;
  int samples_per_pixel = 0;             // of the truth; with `target_se` the most
  std::optional<double> target_se = {};  // of visibility: where the truth stops sampling
  uint64_t seed = 1;                     // of the truth; runs may have their own
};

/// Size and seed, no technique.
inline RenderRequest request_of(const PictureQuality& picture) {
  return {.width_px = picture.width_px,
          .height_px = picture.height_px,
          .seed = picture.seed,
          .technique = {},
          .parameters = {}};
}

}  // namespace umbrameter
