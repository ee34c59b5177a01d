// SPDX-License-Identifier: Apache-2.0
// Without this a drag could turn the wrong way, tip over the pole, or leave the target.

#include "view/camera_control.h"

#include <gtest/gtest.h>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

namespace umbrameter {
namespace {

/// At the origin, looking along -z, y up: right is +x.
Camera ahead() {
  Camera camera;
  camera.eye_world = {0, 0, 0};
  camera.at_world = {0, 0, -2};
  return camera;
}

void expect_near(const glm::dvec3& actual, const glm::dvec3& expected) {
  EXPECT_LT(glm::distance(actual, expected), 1e-12) << actual.x << " " << actual.y << " " << actual.z;
}

TEST(CameraControl, YawOfAQuarterTurnLooksToTheRight) {
  const Camera turned = looked_around(ahead(), glm::radians(90.0), 0.0);
  expect_near(turned.eye_world, {0, 0, 0});
  expect_near(turned.at_world, {2, 0, 0});
}

TEST(CameraControl, PitchLooksUp) {
  const Camera turned = looked_around(ahead(), 0.0, glm::radians(45.0));
  expect_near(turned.at_world, {0, std::sqrt(2.0), -std::sqrt(2.0)});
}

TEST(CameraControl, PitchStopsTwoDegreesBeforeThePole) {
  const Camera turned = looked_around(ahead(), 0.0, glm::radians(200.0));
  const double from_up_deg = glm::degrees(std::acos(turned.at_world.y / 2.0));
  EXPECT_NEAR(from_up_deg, 2.0, 1e-9);
}

TEST(CameraControl, OrbitKeepsTargetAndDistance) {
  const Camera turned = orbited(ahead(), 0.7, -0.3);
  expect_near(turned.at_world, {0, 0, -2});
  EXPECT_NEAR(glm::distance(turned.eye_world, turned.at_world), 2.0, 1e-12);
}

TEST(CameraControl, FlyingMovesEyeAndTargetAlongRightUpForward) {
  const Camera moved = flown(ahead(), {1, 2, 3});
  expect_near(moved.eye_world, {1, 2, -3});
  expect_near(moved.at_world, {1, 2, -5});
}

TEST(CameraControl, DollyHalvesTheDistance) {
  const Camera moved = dollied(ahead(), 0.5);
  expect_near(moved.eye_world, {0, 0, -1});
  expect_near(moved.at_world, {0, 0, -2});
}

TEST(CameraControl, BetweenIsHalfway) {
  Camera to = ahead();
  to.eye_world = {4, 0, 0};
  to.vertical_fov_deg = 65.0;
  const Camera half = between(ahead(), to, 0.5);
  expect_near(half.eye_world, {2, 0, 0});
  EXPECT_DOUBLE_EQ(half.vertical_fov_deg, 55.0);
}

}  // namespace
}  // namespace umbrameter
