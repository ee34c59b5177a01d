// SPDX-License-Identifier: Apache-2.0
#pragma once
// A small square of pixels from known surfaces to finished channels: the grain of adaptive sampling.

#include "reference/embree_scene.h"
#include "reference/light_proof.h"
#include "reference/occluder_tree.h"
#include "reference/primary_hit.h"
#include "reference/reference_planes.h"
#include "reference/sample_sets.h"
#include "scenes/scene.h"

#include <cstdint>
#include <optional>
#include <span>

namespace umbrameter {

/// What every block of a picture shares.
struct BlockJob {
  const Light& light;
  const EmbreeScene& embree;
  const PrimaryCamera& camera;
  const SampleSets& sets;
  uint64_t seed = 1;
  double scene_extent_world = 0.0;  // the greatest coordinate: what rounding errors scale with
  std::optional<double> target_se;
  const Scene& scene;
  const OccluderTree& occluders;
  bool skip_proven = true;
  bool probe_blockers = true;
};

/// The pixels of a block that light can reach, and where they are in the picture: at most kShafts.
struct BlockPixels {
  std::span<const ShaftPixel> shafts;
  std::span<const uint32_t> indices;
};

/// Writes what is seen of the light. Every pixel gets the same number of samples: each half as many as the noisiest one
/// needs for target_se by what the other half shows, or all of the sets' points. Pixels whose visibility is proven
/// (reference/light_proof.h), or `all_lit` for all, take no part in that; they get no samples, or with skip_proven off as
/// many as the others and the same values.
void render_block(const BlockJob& job, const BlockPixels& pixels, bool all_lit, ReferencePlanes& planes);

}  // namespace umbrameter
