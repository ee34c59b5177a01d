// SPDX-License-Identifier: Apache-2.0
// Without these, a light would reach the shaders with the wrong size.

#include "realtime/harness/frame_uniforms.h"
#include "tests/support/procedural_scene.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace umbrameter {
namespace {

Scene scene_with(const Light& light) {
  Scene scene;
  add_floor(scene, {2.0, 2.0});
  scene.camera = camera_above({0, 0, 0}, 2.0, 4.0);
  scene.lights = {light};
  finish_scene(scene);
  return scene;
}

TEST(FrameUniforms, HoldHalfSizesRadiiAndTheTangentOfHalfTheSun) {
  const auto extent = [](const Light& light) {
    return make_frame_data(scene_with(light), 8, 4, 1).light_extent;
  };
  EXPECT_EQ(extent(rect_light_above({0, 3, 0}, {2.0, 6.0})), glm::vec4(1, 3, 0, 0));
  EXPECT_EQ(extent(disk_light_above({0, 3, 0}, 0.5)), glm::vec4(0.5, 0.5, 0, 0));
  EXPECT_EQ(extent(sphere_light({0, 3, 0}, 0.25)), glm::vec4(0.25, 0.25, 0, 0));
  // tan(45 deg) = 1
  EXPECT_FLOAT_EQ(extent(sun_light({0, 1, 0}, std::numbers::pi / 4)).x, 1.0f);
}

TEST(FrameUniforms, HoldTheScreenTheSeedAndTheLightType) {
  const FrameData data =
      make_frame_data(scene_with(sphere_light({1, 3, 2}, 0.5)), 640, 360, 0xffffffff80000005u);
  EXPECT_EQ(data.screen_and_seed, glm::ivec4(640, 360, 5, 0));
  EXPECT_EQ(data.light_type.x, 2);
  EXPECT_EQ(data.light_center_world, glm::vec4(1, 3, 2, 1));
  EXPECT_EQ(data.eye_world, glm::vec4(0, 4, 0, 1));
}

TEST(FrameUniforms, TheClipMatrixPutsTheCornerOfTheViewInTheCornerOfTheScreen) {
  // The camera looks down on a 2 x 2 square that fills a square picture; up is -z.
  const FrameData data = make_frame_data(scene_with(rect_light_above({0, 3, 0}, {1, 1})), 64, 64, 1);
  const glm::vec4 p_clip = data.clip_from_world * glm::vec4(1.0f, 0.0f, -1.0f, 1.0f);
  EXPECT_NEAR(p_clip.x / p_clip.w, 1.0f, 1e-6);
  EXPECT_NEAR(p_clip.y / p_clip.w, 1.0f, 1e-6);
  EXPECT_NEAR(p_clip.w, 4.0f, 1e-6);
}

TEST(LightViewUniforms, HoldTheViewsRangesAndSize) {
  LightView view;
  view.lateral_bounds = {-1, -2, 3, 4};
  view.near_world = 0.5f;
  view.far_world = 9.0f;
  view.is_orthographic = true;
  const LightViewData data = make_light_view_data(view, 1024);
  EXPECT_EQ(data.lateral_bounds, view.lateral_bounds);
  EXPECT_EQ(data.depth_range, glm::vec4(0.5, 9, 1, 1024));
}

}  // namespace
}  // namespace umbrameter
