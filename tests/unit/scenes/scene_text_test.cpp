// SPDX-License-Identifier: Apache-2.0
// Without this a camera or a light that is written could be read back as another.

#include "scenes/scene_text.h"

#include "scenes/read_camera.h"
#include "scenes/read_light.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <glm/geometric.hpp>

namespace umbrameter {
namespace {

using testing::HasSubstr;
using testing::Not;

Light turned(LightType type) {
  Light light;
  light.name = "lamp \"one\"\n";
  light.type = type;
  light.center_world = type == LightType::sun ? glm::dvec3(0.0) : glm::dvec3(1.0 / 3.0, 2.0, -7.0);
  light.direction_world = glm::normalize(glm::dvec3(1, -2, 0.5));
  light.tangent_world = glm::normalize(glm::cross(light.direction_world, glm::dvec3(0.2, 0.1, 1)));
  light.bitangent_world = glm::cross(light.direction_world, light.tangent_world);
  if (type == LightType::rect) light.size_world = {0.1, 3.0};
  if (type == LightType::disk || type == LightType::sphere) light.radius_world = 1e-7;
  if (type == LightType::sun) light.half_angle_rad = 0.004;
  return light;
}

TEST(SceneText, LightsOfEachTypeComeBack) {
  for (const LightType type : {LightType::rect, LightType::disk, LightType::sphere, LightType::sun}) {
    const Light light = turned(type), read = read_light(parse_toml(light_keys(light), "x.toml"));
    EXPECT_EQ(read.name, light.name);
    EXPECT_EQ(read.type, light.type);
    EXPECT_EQ(read.center_world, light.center_world);
    EXPECT_EQ(read.size_world, light.size_world);
    EXPECT_EQ(read.radius_world, light.radius_world);
    EXPECT_NEAR(read.half_angle_rad, light.half_angle_rad, 1e-16);
    EXPECT_LT(glm::distance(read.direction_world, light.direction_world), 1e-15);
    EXPECT_LT(glm::distance(read.tangent_world, light.tangent_world), 1e-15);
    EXPECT_LT(glm::distance(read.bitangent_world, light.bitangent_world), 1e-15);
  }
}

TEST(SceneText, TangentThatFollowsFromTheDirectionIsLeftOut) {
  Light light = turned(LightType::rect);
  EXPECT_THAT(light_keys(light), HasSubstr("tangent"));
  light.tangent_world = default_tangent(light.direction_world);
  EXPECT_THAT(light_keys(light), Not(HasSubstr("tangent")));
}

TEST(SceneText, CamerasComeBackAndLeaveTheirNearPlaneToTheLoader) {
  Camera camera;
  camera.eye_world = {1.0 / 3.0, 1e-9, 1e9};
  camera.vertical_fov_deg = 60;
  const Camera read = read_camera(parse_toml(camera_keys(camera), "x.toml"));
  EXPECT_EQ(read.eye_world, camera.eye_world);
  EXPECT_EQ(read.at_world, camera.at_world);
  EXPECT_EQ(read.up_world, camera.up_world);
  EXPECT_EQ(read.vertical_fov_deg, 60.0);
  EXPECT_EQ(read.near_world, 0.0);
  camera.near_world = 0.25;
  EXPECT_EQ(read_camera(parse_toml(camera_keys(camera), "x.toml")).near_world, 0.25);
}

}  // namespace
}  // namespace umbrameter
