// SPDX-License-Identifier: Apache-2.0
// Without these: a light could have the wrong size (radius for diameter), side or falloff in both renderers
// alike.
#include "scenes/light.h"
#include "core/sampling/sobol.h"
#include "scenes/rounding.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

namespace umbrameter {
namespace {

constexpr double kPi = std::numbers::pi;

double mean_irradiance(const Light& light, const glm::dvec3& p_world, const glm::dvec3& n_world) {
  constexpr uint32_t kCount = 1 << 14;
  double sum = 0.0;
  for (uint32_t i = 0; i < kCount; ++i) {
    sum += sample_light(light, p_world, n_world, scrambled_sobol(i, 7)).irradiance_weight;
  }
  return sum / kCount;
}

Light light_above_origin(LightType type) {
  Light light;
  light.type = type;
  light.center_world = {0, 2, 0};
  light.size_world = {1.0, 3.0};
  light.radius_world = 0.5;
  light.half_angle_rad = 0.1;
  return light;
}

TEST(Light, CoaxialDiskGivesItsClosedFormIrradiance) {
  // Lambertian disk of unit radiance seen on axis: E = pi r^2 / (r^2 + d^2).
  const Light light = light_above_origin(LightType::disk);
  EXPECT_NEAR(mean_irradiance(light, {0, 0, 0}, {0, 1, 0}), kPi * 0.25 / (0.25 + 4.0), 1e-4);
}

TEST(Light, SphereGivesItsClosedFormIrradiance) {
  // A sphere above the horizon: E = pi (r/d)^2 cos(theta).
  const Light light = light_above_origin(LightType::sphere);
  const glm::dvec3 p(1.0, 0.0, 0.0);
  const double distance2 = 5.0;
  EXPECT_NEAR(mean_irradiance(light, p, {0, 1, 0}), kPi * 0.25 / distance2 * (2.0 / std::sqrt(distance2)),
              1e-4);
}

TEST(Light, RectGivesThePolygonFormFactor) {
  // E = 4 * (corner form): for a parallel W x H rect above one corner at height d with a = W/d, b = H/d:
  // E = 1/2 [a/sqrt(1+a^2) atan(b/sqrt(1+a^2)) + b/sqrt(1+b^2) atan(a/sqrt(1+b^2))]; four quarters around the
  // centre.
  const Light light = light_above_origin(LightType::rect);
  const double a = 0.5 / 2.0;
  const double b = 1.5 / 2.0;
  const double quarter = 0.5 * (a / std::sqrt(1 + a * a) * std::atan(b / std::sqrt(1 + a * a)) +
                                b / std::sqrt(1 + b * b) * std::atan(a / std::sqrt(1 + b * b)));
  EXPECT_NEAR(mean_irradiance(light, {0, 0, 0}, {0, 1, 0}), 4 * quarter, 1e-4);
}

TEST(Light, SunHasUnitNormalIrradianceAndItsAngularRadius) {
  const Light light = light_above_origin(LightType::sun);
  // Mean cosine to the axis over the tan-plane disk: 2 (sqrt(1 + t^2) - 1) / t^2 inverted below; t =
  // tan(0.1).
  const double t = std::tan(0.1);
  EXPECT_NEAR(mean_irradiance(light, {5, -3, 2}, {0, 1, 0}), 2.0 * (std::sqrt(1 + t * t) - 1) / (t * t),
              1e-5);
  double largest = 0.0;
  for (uint32_t i = 0; i < 4096; ++i) {
    const double cosine = glm::dot(light_point(light, scrambled_sobol(i, 3)), -light.direction_world);
    largest = std::max(largest, std::acos(std::min(1.0, cosine)));
  }
  EXPECT_LE(largest, 0.1 + 1e-6);
  EXPECT_GT(largest, 0.099);
}

TEST(Light, UnshadowedIrradianceIsTheMeanOfManySamples) {
  for (const LightType type : {LightType::rect, LightType::disk, LightType::sphere, LightType::sun}) {
    const Light light = light_above_origin(type);
    const glm::dvec3 p(0.7, 0.1, -0.4);
    const glm::dvec3 n = glm::normalize(glm::dvec3(0.3, 1.0, 0.2));
    EXPECT_NEAR(unshadowed_irradiance(light, p, n) / mean_irradiance(light, p, n), 1.0, 5e-4)
        << to_text(type);
    // The light straddles this receiver's horizon: normal at right angles to the direction of its centre.
    const glm::dvec3 grazing = glm::normalize(glm::cross(glm::dvec3(0, 2, 0) - p, glm::dvec3(0, 0, 1)));
    EXPECT_NEAR(unshadowed_irradiance(light, p, grazing) / mean_irradiance(light, p, grazing), 1.0, 5e-3)
        << to_text(type);
  }
}

TEST(Light, FlatLightsAreDarkBehind) {
  for (const LightType type : {LightType::rect, LightType::disk}) {
    const Light light = light_above_origin(type);
    EXPECT_EQ(mean_irradiance(light, {0, 4, 0}, {0, -1, 0}), 0.0);
  }
}

TEST(Light, RectSpansItsFullSize) {
  const Light light = light_above_origin(LightType::rect);
  EXPECT_EQ(light_point(light, {0, 0}), glm::dvec3(-0.5, 2, -1.5));
  EXPECT_EQ(light_point(light, {1, 1}), glm::dvec3(0.5, 2, 1.5));
}

TEST(Light, RaysToASphereHitItFromEveryDistance) {
  const Light light = light_above_origin(LightType::sphere);
  for (const double distance : {0.51, 1.0, 100.0}) {
    const glm::dvec3 p(distance, 2, 0);
    for (uint32_t i = 0; i < 256; ++i) {
      const LightSample sample = sample_light(light, p, {-1, 0, 0}, scrambled_sobol(i, 5));
      const glm::dvec3 end = p + sample.distance_world * sample.to_light_world;
      ASSERT_NEAR(glm::length(end - light.center_world), 0.5, 1e-5 * distance) << distance;
    }
  }
}

TEST(Light, NarrowerThanItsPositionsAreToldApartIsSaid) {
  Scene scene;
  scene.bounds_world = {{-4, 0, -4}, {4, 4, 4}};  // a float's rounding at 4 is 2.4e-7
  const auto warnings = [&](LightType type, double width_world) {
    Light light = light_above_origin(type);
    light.name = "lamp";
    light.size_world = {width_world, 1.0};
    light.radius_world = width_world / 2;
    light.half_angle_rad = width_world / 2 / scene.bounds_world.diagonal();
    scene.lights = {light};
    return narrow_light_warnings(scene);
  };
  for (const LightType type : {LightType::rect, LightType::disk, LightType::sphere, LightType::sun}) {
    EXPECT_THAT(warnings(type, 1e-4), testing::IsEmpty()) << to_text(type);
    EXPECT_THAT(warnings(type, 1e-6), testing::ElementsAre(testing::HasSubstr(
                                          "light 'lamp' is 1e-06 wide and positions are rounded by up to "
                                          "2.4e-07: its penumbrae are true to about 0.24 of it")))
        << to_text(type);
    EXPECT_THAT(warnings(type, 0.0), testing::IsEmpty()) << to_text(type);
  }
}

}  // namespace
}  // namespace umbrameter
