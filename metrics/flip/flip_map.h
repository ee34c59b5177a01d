// SPDX-License-Identifier: Apache-2.0
#pragma once
// FLIP of two pictures in linear RGB, pixel by pixel; what LDR-FLIP and HDR-FLIP share.

#include <functional>
#include <span>
#include <vector>

namespace umbrameter {

/// Linear red, green, blue in [0,1] of one row; of a grey picture only red, the others being the same.
struct LinearRow {
  std::span<float> red, green, blue;
};

/// A picture, row by row.
struct FlipSource {
  std::function<void(int y, const LinearRow& row)> fill;
  bool is_grey = false;
};

/// What FLIP's observer sees of a picture, [height][width] each: 12 bytes a pixel of a grey one, else 20.
struct SeenPicture {
  int width = 0, height = 0;
  std::vector<float> lightness, a,
      b;                           // CIELab with the Hunt effect; a and b of a grey picture are 0 and empty
  std::vector<float> edge, point;  // magnitudes
};

/// `ppd` pixels per degree. The same bits with any number of threads, like flip_map.
SeenPicture see_picture(const FlipSource& picture, int width, int height, double ppd);

/// [height][width] in [0,1], 0 = equal. `reference` is of the same size, as grey as `test` and seen at the same `ppd`.
std::vector<float> flip_map(const FlipSource& test, const SeenPicture& reference, double ppd);

}  // namespace umbrameter
