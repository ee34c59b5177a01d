#include "reference/patch_irradiance.h"

#include "reference/shadow_rays.h"

#include <algorithm>
#include <array>
#include <limits>
#include <numeric>
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

GridMean mean_over(const Grid& grid, const LightPatch& patch, ShadowRayBatch& batch) {
  const SampleStream stream{grid.x.data(), grid.y.data(), 0, 0};
  const uint32_t points = grid.side * grid.side;
  static_assert(kBatch == 16);  // all grids are whole batches
  std::array<double, kBatch> sums{};
  Lanes least;
  least.fill(std::numeric_limits<float>::max());
  for (uint32_t first = 0; first < points; first += kBatch) {
    make_shadow_rays(patch, stream, first, points, batch);
    for (uint32_t i = 0; i < kBatch; ++i) {
      sums[i] += static_cast<double>(batch.weight[i]);
      least[i] = std::min(least[i], batch.weight[i]);
    }
  }
  return {std::accumulate(sums.begin(), sums.end(), 0.0) / points, std::ranges::min(least) == 0.0f};
}

}  // namespace

double unshadowed_irradiance(const LightPatch& patch) {
  static const Grid coarse(4), fine(8), finest(32);
  thread_local ShadowRayBatch batch(glm::vec3(0.0f));  // costs as much to set up as a grid to sum
  if (patch.dark) return 0.0;
  const GridMean mean = mean_over(fine, patch, batch);
  if (mean.straddles_horizon) return mean_over(finest, patch, batch).irradiance;
  // Richardson: the midpoint rule's error falls with the square of the cell's side.
  return (4.0 * mean.irradiance - mean_over(coarse, patch, batch).irradiance) / 3.0;
}

}  // namespace umbrameter
