// SPDX-License-Identifier: Apache-2.0
#pragma once
// What is true: Embree primary hits and stochastic area-light visibility.

#include "core/renderer.h"

#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace umbrameter {

struct ReferenceSettings {
  /// Samples a pixel, a multiple of kReplicates; rounded up. With target_se it is the upper limit.
  int samples_per_pixel = 1024;
  /// When set, sampling of a pixel block stops once every pixel's standard error promises to be at or below it. Each half
  /// of the replicates is judged by the other, so that stopping biases neither the visibility nor its stated error;
  /// hence the latter scatters about the target.
  std::optional<double> target_se;
  int threads = 0;  // 0 = all
  /// Off: pixels whose visibility is proven are sampled all the same. Only sample_count may change.
  bool skip_proven = true;
  /// Off: no rays that ask what stands in the way; the six channels they fill are missing.
  bool probe_blockers = true;
};

// What the channels of core/renderer.h mean here, per pixel, seen through its centre:
//   visibility, half_a, half_b
//       Geometric visibility: the mean over all samples, and over one half of the replicates each. A sample below
//       the receiver's geometric plane or behind a one-sided light is not seen.
//   visibility_se
//       Standard error of visibility from the spread of the replicates, never below 0.5 / samples: samples that all
//       agree can still miss an occluder. 0 only where visibility is proven (reference/light_proof.h).
//   irradiance_ratio
//       S = sum(w v) / sum(w), w = cosine (shading normal) x cosine at the light x falloff; 0 where sum(w) is 0.
//   irradiance_ratio_se, irradiance_half_a, irradiance_half_b
//       Of S what visibility_se, half_a and half_b are of visibility; the error of a ratio by the delta method.
//   unshadowed_irradiance
//       unshadowed_irradiance() of scenes/light.h: per unit radiance; sun: per unit irradiance at normal incidence.
//   sample_count
//       Samples taken, also those that only judged when to stop; 0 where visibility is proven, unless skip_proven is off.
//   blocker_distance, blocker_distance_min, blocker_distance_p10, blocker_layers, penumbra_width, contact_distance,
//   blocker_offset.x/y/z
//       From 16 further rays, where visibility < 1; 0 when none of them is blocked. Mean, least and 10th-percentile (nearest
//       rank) distance (world) from the receiver to the first surface on a blocked ray; mean number of layers on a blocked
//       ray: its surfaces wound towards the light or those wound away, whichever are more, so that a solid is one layer as
//       a sheet is. Surfaces closer than 1e-6 of their distance count once. Mean width (world) that the penumbra has across
//       the rays, by similar triangles from the first surface and the light's width (diameter; of a rectangle the root of
//       its area). Least height (world) of a first surface over the receiver's plane: 0 where a blocker stands on it.
//       Mean way (world) from the receiver to the first surface: its length along any axis is the mean of that axis' distances.
// Background: visibility, irradiance_ratio and their halves are 1, primitive_id -1, everything else 0.

/// Independently scrambled Sobol sets per pixel: 4 make half A, 4 make half B; their spread gives the
/// standard error (7 degrees of freedom).
inline constexpr int kReplicates = 8;

/// A Renderer over Embree; builds its acceleration structure per scene and keeps the last one.
std::unique_ptr<Renderer> make_reference_renderer(const ReferenceSettings& settings);

/// One for each of `settings`, which share the acceleration structure: not to be used at the same time.
std::vector<std::unique_ptr<Renderer>> make_reference_renderers(std::span<const ReferenceSettings> settings);

}  // namespace umbrameter
