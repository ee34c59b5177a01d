// SPDX-License-Identifier: Apache-2.0
#pragma once
// Shadow rays of one pixel: tracing them in packets, and what their sums say.

#include "reference/embree_scene.h"
#include "reference/reference.h"
#include "reference/sample_sets.h"
#include "reference/shadow_rays.h"

#include <array>
#include <cstdint>

namespace umbrameter {

/// All replicates of one pixel, each with `points` samples so far.
struct PixelSums {
  uint32_t points = 0;
  std::array<ReplicateSums, kReplicates> replicates;
};

/// What a pixel's sums estimate; definitions in reference/reference.h.
struct PixelEstimate {
  double visibility = 0.0;
  double visibility_se = 0.0;
  double half_a = 0.0;
  double half_b = 0.0;
  double irradiance_ratio = 0.0;
  double irradiance_ratio_se = 0.0;
  double irradiance_half_a = 0.0;
  double irradiance_half_b = 0.0;
  uint32_t sample_count = 0;
};

/// Extends `sums` to `points` samples a replicate.
void sample_pixel(const EmbreeScene& embree, const glm::vec3& origin_world, const LightPatch& patch,
                  const SampleSets& sets, uint32_t seed, uint32_t points, PixelSums& sums);

enum class Half { a, b };

/// The standard error that one half's replicates alone promise for all of them.
double standard_error_by(Half half, const PixelSums& sums);

/// Half A as it is in `a`, half B as it is in `b`; sample_count counts both.
PixelEstimate estimate_pixel(const PixelSums& a, const PixelSums& b);

}  // namespace umbrameter
