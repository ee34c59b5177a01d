// SPDX-License-Identifier: Apache-2.0
#include "reference/ray_budget.h"

#include <algorithm>

namespace umbrameter {

RayBudget ray_budget(const Image& reference) {
  const auto id = reference.plane("primitive_id");
  const auto visibility = reference.plane("visibility");
  const auto se = reference.plane("visibility_se");
  const auto samples = reference.plane("sample_count");
  const auto irradiance = reference.plane("unshadowed_irradiance");
  RayBudget budget;
  double most = 0.0;
  for (size_t i = 0; i < id.size(); ++i) {
    const auto count = static_cast<double>(samples[i]);
    budget.rays_per_pixel += count;
    most = std::max(most, count);
    if (id[i] < 0.0f) {
      budget.background += 1.0;
    } else if (se[i] > 0.0f) {
      budget.sampled += 1.0;
    } else if (visibility[i] > 0.0f) {
      budget.proven_lit += 1.0;
    } else {
      (irradiance[i] > 0.0f ? budget.proven_dark : budget.unlit) += 1.0;
    }
  }
  const auto n = static_cast<double>(id.size());
  budget.uniform_rays_per_pixel = most * (n - budget.background - budget.unlit) / n;
  for (double* sum : {&budget.rays_per_pixel, &budget.background, &budget.unlit, &budget.proven_lit,
                      &budget.proven_dark, &budget.sampled}) {
    *sum /= n;
  }
  return budget;
}

}  // namespace umbrameter
