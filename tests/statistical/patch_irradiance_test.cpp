// SPDX-License-Identifier: Apache-2.0
// The fast quadrature must be the light's own irradiance, and where the horizon cuts the light that of scenes/light.h, which
// real-time renderers are held to.

#include "reference/patch_irradiance.h"
#include "tests/support/procedural_scene.h"

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

namespace umbrameter {
namespace {

/// By the midpoint rule on so many cells that its error is far below the tolerance.
double converged_irradiance(const Light& light, const glm::dvec3& p_world, const glm::dvec3& n_world) {
  constexpr int kSide = 512;
  double sum = 0.0;
  for (int i = 0; i < kSide * kSide; ++i) {
    const glm::dvec2 uv = (glm::dvec2(i % kSide, i / kSide) + 0.5) / static_cast<double>(kSide);
    sum += sample_light(light, p_world, n_world, uv).irradiance_weight;
  }
  return sum / (kSide * kSide);
}

TEST(PatchIrradiance, is_that_of_the_light) {
  const std::vector<Light> lights = {rect_light_above({0.2, 2, 0}, {1.0, 0.5}),
                                     disk_light_above({0, 3, 0.4}, 0.7), sphere_light({-0.5, 2, 0}, 0.6),
                                     sun_light({0.3, 1, 0.2}, 0.05)};
  for (const Light& light : lights) {
    // Facing it, tilted, and with the horizon through the light.
    for (const glm::dvec3& n : {glm::dvec3(0, 1, 0), glm::dvec3(0.5, 1, -0.3), glm::dvec3(1, 0.05, 0.1)}) {
      const glm::dvec3 n_world = glm::normalize(n);
      const Receiver receiver{{0.1, 0, 0.3}, n_world, n_world, {0.1f, 0.0f, 0.3f}};
      const LightPatch patch = make_light_patch(light, receiver, 4.0);
      const double expected = straddles_horizon(patch)
                                  ? unshadowed_irradiance(light, receiver.p_world, n_world)
                                  : converged_irradiance(light, receiver.p_world, n_world);
      EXPECT_NEAR(unshadowed_irradiance(patch), expected, 2e-5 * expected + 1e-6)
          << to_text(light.type) << " " << n.x;
    }
  }
}

}  // namespace
}  // namespace umbrameter
