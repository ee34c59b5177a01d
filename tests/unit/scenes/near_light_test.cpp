// SPDX-License-Identifier: Apache-2.0
// Without these: a receiver close to a large light gets an irradiance that is wrong, or negative.
#include "scenes/near_light.h"

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include <numbers>

namespace umbrameter {
namespace {

constexpr double kPi = std::numbers::pi;

Light light_of(LightType type) {
  Light light;  // faces -y
  light.type = type;
  light.center_world = {0.2, 1.0, -0.1};
  light.size_world = {2.0, 1.2};
  light.radius_world = 0.9;
  return light;
}

/// The mean over so fine a grid that no peak is missed.
double fine_mean(const Light& light, const glm::dvec3& p_world, const glm::dvec3& n_world) {
  constexpr int kSide = 1500;
  double sum = 0.0;
  for (int y = 0; y < kSide; ++y) {
    for (int x = 0; x < kSide; ++x)
      sum += sample_light(light, p_world, n_world, {(x + 0.5) / kSide, (y + 0.5) / kSide}).irradiance_weight;
  }
  return sum / (kSide * kSide);
}

TEST(NearLight, is_the_mean_over_a_fine_grid) {
  for (const LightType type : {LightType::rect, LightType::disk, LightType::sphere}) {
    const Light light = light_of(type);
    // Under it, at its rim, beside it; facing it, tilted, with the horizon through it.
    for (const glm::dvec3& p :
         {glm::dvec3(0.3, 0.05, 0.1), glm::dvec3(1.1, 0.4, 0.0), glm::dvec3(-1.4, 0.6, 0.2)}) {
      for (const glm::dvec3& n : {glm::dvec3(0, 1, 0), glm::dvec3(0.5, 1, -0.3), glm::dvec3(1, 0.05, 0.1)}) {
        const glm::dvec3 n_world = glm::normalize(n);
        const double expected = fine_mean(light, p, n_world);
        EXPECT_NEAR(near_irradiance(light, p, n_world), expected, 2e-3 * expected + 1e-4)
            << to_text(type) << " p " << p.x << " n " << n.x;
      }
    }
  }
}

TEST(NearLight, a_ceiling_without_end_gives_pi) {
  Light light = light_of(LightType::rect);
  light.size_world = glm::dvec2(1e6);
  EXPECT_NEAR(near_irradiance(light, {0, 0, 0}, {0, 1, 0}), kPi, 1e-5);
  // Facing sideways, half of it lies below the horizon.
  EXPECT_NEAR(near_irradiance(light, {0, 0, 0}, {1, 0, 0}), 0.5 * kPi, 1e-5);
}

TEST(NearLight, is_never_negative) {
  Light light = light_of(LightType::rect);
  light.size_world = glm::dvec2(0.5);
  for (const double height : {1e-1, 1e-2, 1e-3, 1e-6, 0.0, -1e-3}) {
    for (const double x : {0.0, 0.2, 0.25, 0.3, 1.0}) {
      const glm::dvec3 p = light.center_world + glm::dvec3(x, -height, 0.01);
      EXPECT_GE(unshadowed_irradiance(light, p, {0, 1, 0}), 0.0) << height << " " << x;
      EXPECT_LE(unshadowed_irradiance(light, p, {0, 1, 0}), kPi * (1.0 + 1e-6)) << height << " " << x;
    }
  }
}

TEST(NearLight, is_dark_behind_in_the_plane_and_inside) {
  const Light rect = light_of(LightType::rect), sphere = light_of(LightType::sphere);
  EXPECT_EQ(near_irradiance(rect, {0.2, 1.0, -0.1}, {0, 1, 0}), 0.0);
  EXPECT_EQ(near_irradiance(rect, {3.0, 1.0, -0.1}, {-1, 0, 0}), 0.0);
  EXPECT_EQ(near_irradiance(rect, {0.2, 1.1, -0.1}, {0, -1, 0}), 0.0);
  EXPECT_EQ(near_irradiance(sphere, {0.2, 1.5, -0.1}, {0, 1, 0}), 0.0);
}

TEST(NearLight, joins_the_grid_without_a_step) {
  for (const LightType type : {LightType::rect, LightType::disk, LightType::sphere}) {
    const Light light = light_of(type);
    for (double height = 0.5; height < 2.5; height += 0.01) {
      const glm::dvec3 p = light.center_world - glm::dvec3(0.3, height, 0.2);
      const glm::dvec3 n = glm::normalize(glm::dvec3(0.2, 1, 0));
      if (is_near_light(light, p) || is_near_light(light, p + glm::dvec3(0, 0.02, 0)) == false) continue;
      EXPECT_NEAR(unshadowed_irradiance(light, p, n) / near_irradiance(light, p, n), 1.0, 2e-3)
          << to_text(type);
    }
  }
}

}  // namespace
}  // namespace umbrameter
