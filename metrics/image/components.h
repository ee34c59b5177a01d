// SPDX-License-Identifier: Apache-2.0
#pragma once
// Connected components of a mask.

#include <cstdint>
#include <span>
#include <vector>

namespace umbrameter {

struct Components {
  std::vector<int32_t>
      label;  // [height][width], -1 outside the mask; labels in reading order of first pixels
  size_t count = 0;
};

/// 8-connected components of the pixels where `mask` is not 0; different values do not connect. Near linear
/// (union-find over strips of rows, joined afterwards).
Components label_components(std::span<const uint8_t> mask, int width, int height);

}  // namespace umbrameter
