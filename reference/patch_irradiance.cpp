#include "reference/patch_irradiance.h"

#include "reference/shadow_rays.h"

#include <vector>

namespace umbrameter {

namespace {

/// Midpoints of side x side cells as 32-bit fractions, which a stream reads as signed: the grid is symmetric.
struct Grid {
  uint32_t side;
  std::vector<uint32_t> x, y;

  explicit Grid(uint32_t cells) : side(cells) {
    const uint32_t step = static_cast<uint32_t>((uint64_t{1} << 32) / side);
    for (uint32_t i = 0; i < side * side; ++i) {
      x.push_back(step / 2 + step * (i % side));
      y.push_back(step / 2 + step * (i / side));
    }
  }
};

struct GridMean {
  double irradiance = 0.0;
  bool straddles_horizon = false;
};

GridMean mean_over(const Grid& grid, const LightPatch& patch) {
  const SampleStream stream{grid.x.data(), grid.y.data(), 0, 0};
  const uint32_t points = grid.side * grid.side;
  static_assert(kBatch == 16);  // all grids are whole batches
  ShadowRayBatch batch(glm::vec3(0.0f));
  GridMean mean;
  for (uint32_t first = 0; first < points; first += kBatch) {
    make_shadow_rays(patch, stream, first, points, batch);
    for (const float weight : batch.weight) {
      mean.irradiance += static_cast<double>(weight) / points;
      mean.straddles_horizon |= weight == 0.0f;
    }
  }
  return mean;
}

}  // namespace

double unshadowed_irradiance(const LightPatch& patch) {
  static const Grid coarse(4), fine(8), finest(32);
  if (patch.dark) return 0.0;
  const GridMean mean = mean_over(fine, patch);
  if (mean.straddles_horizon) return mean_over(finest, patch).irradiance;
  // Richardson: the midpoint rule's error falls with the square of the cell's side.
  return (4.0 * mean.irradiance - mean_over(coarse, patch).irradiance) / 3.0;
}

}  // namespace umbrameter
