#pragma once
// What is true: Embree primary hits and stochastic area-light visibility.

#include "core/renderer.h"

#include <memory>
#include <optional>

namespace umbrameter {

struct ReferenceSettings {
  /// Samples a pixel, a multiple of kReplicates; rounded up. With target_se it is the upper limit.
  int samples_per_pixel = 1024;
  /// When set, sampling of a pixel block stops once every pixel's visibility_se is at or below it.
  std::optional<double> target_se;
  int threads = 0;  // 0 = all
};

/// Independently scrambled Sobol sets per pixel: 4 make half A, 4 make half B; their spread gives the
/// standard error (7 degrees of freedom).
inline constexpr int kReplicates = 8;

/// A Renderer over Embree; builds its acceleration structure per scene and keeps the last one.
std::unique_ptr<Renderer> make_reference_renderer(const ReferenceSettings& settings);

}  // namespace umbrameter
