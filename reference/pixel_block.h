#pragma once
// A small square of pixels from primary hits to finished channels: the grain of adaptive sampling.

#include "reference/embree_scene.h"
#include "reference/primary_hit.h"
#include "reference/reference_planes.h"
#include "reference/sample_sets.h"
#include "scenes/scene.h"

#include <optional>

namespace umbrameter {

inline constexpr int kBlock = 4;  // pixels

/// What every block of a picture shares.
struct BlockJob {
  const Light& light;
  const EmbreeScene& embree;
  const PrimaryCamera& camera;
  const SampleSets& sets;
  uint64_t seed = 1;
  double scene_extent_world = 0.0;  // the greatest coordinate: what rounding errors scale with
  std::optional<double> target_se;
};

/// Renders the block whose first pixel is (x0, y0), cut at the picture's border. Every pixel gets the same
/// number of samples: as many as the noisiest one needs for target_se, or all of the sets' points.
void render_block(const BlockJob& job, int x0, int y0, ReferencePlanes& planes);

}  // namespace umbrameter
