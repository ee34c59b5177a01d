// SPDX-License-Identifier: Apache-2.0
#pragma once
// What stands between a shadowed receiver and the light: distances and layers, from a few probe rays.

#include "reference/embree_scene.h"
#include "reference/sample_sets.h"
#include "reference/shadow_rays.h"

namespace umbrameter {

inline constexpr uint32_t kProbes = kBatch;

/// Definitions in reference/reference.h; all 0 when no probe is blocked.
struct BlockerStatistics {
  double distance_mean_world = 0.0;
  double distance_min_world = 0.0;
  double distance_p10_world = 0.0;
  double layers_mean = 0.0;
  double penumbra_width_world = 0.0;
  double contact_distance_world = 0.0;
  glm::dvec3 offset_mean_world{0.0};  // from the receiver
};

/// The receiver's place and normal, and the light as seen from there.
struct ProbeJob {
  const EmbreeScene& embree;
  const Light& light;
  const LightPatch& patch;
  glm::vec3 origin_world{0.0f};
  glm::vec3 n_geometric_world{0.0f};
};

/// Shoots kProbes rays of a set that no visibility sample uses.
BlockerStatistics probe_blockers(const ProbeJob& job, const SampleSets& sets, uint32_t seed);

}  // namespace umbrameter
