// SPDX-License-Identifier: Apache-2.0
// What adaptive sampling is for: the same error with a fraction of the rays. The measurement at full size is bench_truth share.

#include "reference/ray_budget.h"
#include "reference/reference.h"
#include "tests/support/models.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <iostream>

namespace umbrameter {
namespace {

Image picture_of(const Scene& scene, int samples, std::optional<double> target_se) {
  SilentProgress progress;
  RenderRequest request;
  request.width_px = 240;
  request.height_px = 135;
  return make_reference_renderer({samples, target_se, 0, true, false})
      ->render(scene, request, progress)
      .image;
}

/// By the difference of the halves, which err independently.
double rmse_of(const Image& image) {
  const auto a = image.plane("half_a"), b = image.plane("half_b");
  double sum = 0.0;
  for (size_t i = 0; i < a.size(); ++i) sum += std::pow(0.5 * (static_cast<double>(a[i]) - b[i]), 2);
  return std::sqrt(sum / static_cast<double>(a.size()));
}

TEST(RayShare, the_bunny_takes_at_most_15_percent_of_the_rays_of_uniform_sampling) {
  if (!has_models()) GTEST_SKIP() << no_models();
  const SceneSearch search = model_search();
  const Scene scene = load_scene(search.library / "assets/bunny.toml", search);
  const Image adaptive = picture_of(scene, 1 << 14, 0.002);
  const RayBudget budget = ray_budget(adaptive);
  const double few = rmse_of(picture_of(scene, 256, {})), many = rmse_of(picture_of(scene, 1024, {}));
  const double exponent = std::log(many / few) / std::log(4.0);
  EXPECT_LT(exponent, -0.5);
  const double samples = 1024 * std::pow(rmse_of(adaptive) / many, 1.0 / exponent);
  const double share = budget.rays_per_pixel / (samples * (1.0 - budget.background - budget.unlit));
  std::cout << fmt::format(
      "{:.0f} rays per pixel for an RMSE of {:.5f}; uniform sampling needs {:.0f} samples: {:.1f} %\n",
      budget.rays_per_pixel, rmse_of(adaptive), samples, 100.0 * share);
  EXPECT_LT(share, 0.15);
}

}  // namespace
}  // namespace umbrameter
