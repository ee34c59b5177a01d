// SPDX-License-Identifier: Apache-2.0
#pragma once
// sRGB's transfer function (IEC 61966-2-1).

#include <cmath>

namespace umbrameter {

inline double linear_of_srgb(double stored) {
  return stored <= 0.04045 ? stored / 12.92 : std::pow((stored + 0.055) / 1.055, 2.4);
}

}  // namespace umbrameter
