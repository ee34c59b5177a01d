// The fast quadrature must be that of scenes/light.h, which real-time renderers are held to.

#include "reference/patch_irradiance.h"
#include "tests/support/procedural_scene.h"

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

namespace umbrameter {
namespace {

TEST(PatchIrradiance, is_that_of_the_light) {
  const std::vector<Light> lights = {rect_light_above({0.2, 2, 0}, {1.0, 0.5}),
                                     disk_light_above({0, 3, 0.4}, 0.7), sphere_light({-0.5, 2, 0}, 0.6),
                                     sun_light({0.3, 1, 0.2}, 0.05)};
  for (const Light& light : lights) {
    // Facing it, tilted, and with the horizon through the light.
    for (const glm::dvec3& n : {glm::dvec3(0, 1, 0), glm::dvec3(0.5, 1, -0.3), glm::dvec3(1, 0.05, 0.1)}) {
      const glm::dvec3 n_world = glm::normalize(n);
      const Receiver receiver{{0.1, 0, 0.3}, n_world, n_world, {0.1f, 0.0f, 0.3f}};
      const double expected = unshadowed_irradiance(light, receiver.p_world, n_world);
      EXPECT_NEAR(unshadowed_irradiance(make_light_patch(light, receiver, 4.0)), expected,
                  2e-5 * expected + 1e-6)
          << to_text(light.type) << " " << n.x;
    }
  }
}

}  // namespace
}  // namespace umbrameter
