#pragma once
// Edges and points as FLIP's observer sees them.

#include <span>
#include <vector>

namespace umbrameter {

struct Features {
  std::vector<float> edge, point;  // [height][width] magnitudes
};

/// First and second Gaussian derivatives of the achromatic plane (Y of YCxCz), `ppd` pixels per degree.
Features find_features(std::span<const float> achromatic, int width, int height, double ppd);

}  // namespace umbrameter
