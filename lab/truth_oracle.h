// SPDX-License-Identifier: Apache-2.0
#pragma once
// The reference against exact arithmetic, at a few points of a picture.

#include "core/image.h"
#include "scenes/scene.h"

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace umbrameter {

/// A point of a surface that a picture shows, in double: where the pixel's ray meets the plane of its triangle.
struct ReceiverPoint {
  size_t pixel = 0;
  uint32_t triangle = 0;
  glm::dvec3 p_world{0.0};
  glm::dvec3 n_world{0.0};  // faces the camera
};

/// Exact visibilities of the scene's active light; nothing for scenes that it is not exact for.
using TruthOracle =
    std::function<std::optional<std::vector<double>>(const Scene& scene, std::span<const ReceiverPoint>)>;

struct TruthCheck {
  size_t points = 0;  // 0: the oracle cannot tell
  size_t beyond = 0;  // of them, further from the oracle than noise goes
  double worst = 0.0;
  std::optional<std::string> objection;
};

/// Compares at up to `most` points, those in penumbrae first. One in 32 may lie beyond 8 standard errors and 0.001:
/// 8 replicates have long tails.
TruthCheck check_truth(const Scene& scene, const Image& reference, std::span<const uint8_t> mask,
                       const TruthOracle& oracle, size_t most = 64);

}  // namespace umbrameter
