// SPDX-License-Identifier: Apache-2.0
#pragma once
// Shadow rays by the batch: made from a light patch, and summed after tracing. Not here: tracing.

#include "reference/light_patch.h"
#include "reference/sample_sets.h"

#include <embree3/rtcore.h>

#include <array>
#include <cstdint>

namespace umbrameter {

inline constexpr uint32_t kBatch = 16;
using Lanes = std::array<float, kBatch>;

/// Rays from one origin through kBatch samples, laid out as Embree's packet so that nothing need be copied.
/// Directions are not unit: the sample lies at 1, the ray ends at rays.tfar, which tracing makes -infinity
/// when it is blocked.
struct alignas(64) ShadowRayBatch {
  explicit ShadowRayBatch(const glm::vec3& origin_world);

  RTCRay16 rays;
  std::array<int32_t, kBatch> is_facing{};  // -1 above the receiver's geometric plane, else 0
  Lanes weight{};                           // irradiance weight
  bool any_facing = false;
};

/// Sums over the samples of one replicate.
struct ReplicateSums {
  uint32_t seen = 0;
  double weight = 0.0;
  double weight_seen = 0.0;
};

/// The same, each lane for itself: counts stay exact up to 2^24 samples a lane.
struct alignas(64) LaneSums {
  Lanes seen{};
  Lanes weight{};
  Lanes weight_seen{};
};

/// Fills `batch` with the samples first .. first + kBatch - 1 of `stream`; those from `end` on neither face
/// the light nor weigh.
void make_shadow_rays(const LightPatch& patch, const SampleStream& stream, uint32_t first, uint32_t end,
                      ShadowRayBatch& batch);

/// The batch's directions and ends as two packets of 8, and back where those rays ended. In steps as wide as the machine
/// reads: what is written in halves must wait before it is read as a whole.
void to_packets_of_8(const ShadowRayBatch& batch, std::array<RTCRay8, 2>& packets);
void from_packets_of_8(const std::array<RTCRay8, 2>& packets, ShadowRayBatch& batch);

/// Adds a batch: rays that face the light, and were not blocked if they were traced, are seen.
void add_rays(const ShadowRayBatch& batch, LaneSums& sums);
void add_lanes(const LaneSums& lanes, ReplicateSums& sums);

}  // namespace umbrameter
