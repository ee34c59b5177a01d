// SPDX-License-Identifier: Apache-2.0
// Without these a sequence could stand still, jump by whole texels, or show another frame than it says.
#include "scenes/motion.h"

#include "scenes/load_scene.h"
#include "scenes/scene_hash.h"
#include "tests/support/procedural_scene.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include <cmath>

namespace umbrameter {
namespace {

using testing::AllOf;
using testing::HasSubstr;

constexpr int kHeight_px = 100;

Scene lit_by(const Light& light) {
  Scene scene;
  add_floor(scene, {8, 8});
  scene.parts = {{"floor", 0, 2}};
  add_box(scene, {-1, 1, -1}, {1, 2, 1});
  scene.parts.push_back({"box", 2, 12});
  scene.camera.eye_world = {0, 3, 10};
  scene.camera.at_world = {0, 0, 0};
  scene.lights = {light};
  finish_scene(scene);
  return scene;
}

Scene moved(Scene scene, std::string_view motion, int frame) {
  scene.motion = standard_motion(motion, scene);
  return scene_at(scene, frame, kHeight_px);
}

TEST(Motion, PansByIrrationalPixels) {
  const Scene scene = lit_by(rect_light_above({0, 10, 0}, {1, 1}));
  const Camera& start = scene.camera;
  const Camera camera = moved(scene, "pan", 2).camera;
  const double px_world = 2.0 * glm::distance(start.eye_world, start.at_world) *
                          std::tan(glm::radians(0.5 * start.vertical_fov_deg)) / kHeight_px;
  const glm::dvec3 step = (camera.eye_world - start.eye_world) / px_world;
  EXPECT_NEAR(step.x, 2.0 * 3.618034, 1e-5);
  EXPECT_NEAR(glm::length(step), 2.0 * std::hypot(3.618034, 1.414214), 1e-5);
  EXPECT_NEAR(glm::distance(camera.at_world - camera.eye_world, start.at_world - start.eye_world), 0.0,
              1e-12);
}

TEST(Motion, MovesALightAsideAndTurnsTheSun) {
  const Scene rect = lit_by(rect_light_above({0, 10, 0}, {1, 1}));
  const Light light = moved(rect, "light", 3).light();
  EXPECT_NEAR(glm::distance(light.center_world, rect.light().center_world), 3 * 0.0618034, 1e-6);
  const Light sun = moved(lit_by(sun_light({0, 1, 0}, 0.01)), "light", 3).light();
  EXPECT_NEAR(std::acos(glm::dot(sun.direction_world, glm::dvec3(0, -1, 0))), 3 * 0.00618034, 1e-6);
  EXPECT_NEAR(glm::dot(sun.direction_world, sun.tangent_world), 0.0, 1e-12);
}

TEST(Motion, GoesOnWhereAFrameOfItIs) {
  for (const char* name : {"pan", "light"}) {
    Scene scene = lit_by(rect_light_above({1, 10, 0}, {1, 1}));
    scene.motion = standard_motion(name, scene);
    const Scene there = scene_at(scene_at(scene, 5, kHeight_px), -7, kHeight_px);
    const Scene straight = scene_at(scene, -2, kHeight_px);
    EXPECT_NEAR(glm::distance(there.camera.eye_world, straight.camera.eye_world), 0.0, 1e-12) << name;
    EXPECT_NEAR(glm::distance(there.light().center_world, straight.light().center_world), 0.0, 1e-12) << name;
  }
}

TEST(Motion, LooksTheOtherWayBeforeACut) {
  const Scene scene = lit_by(rect_light_above({0, 10, 0}, {1, 1}));
  const auto ahead = [](const Camera& camera) { return glm::normalize(camera.at_world - camera.eye_world); };
  EXPECT_EQ(ahead(moved(scene, "cut", 0).camera), ahead(scene.camera));
  for (const int frame : {-1, -9})
    EXPECT_NEAR(glm::dot(ahead(moved(scene, "cut", frame).camera), ahead(scene.camera)), -1.0, 1e-12);
}

TEST(Motion, MovesTheVerticesOfItsObjectAlone) {
  Scene scene = lit_by(rect_light_above({0, 10, 0}, {1, 1}));
  scene.motion.object = "box";
  scene.motion.object_step_world = {0.5, 0, 0};
  const Scene before = scene_at(scene, -4, kHeight_px);
  for (size_t v = 0; v < scene.positions_world.size(); ++v) {
    const bool is_floor = scene.positions_world[v].y == 0.0f;
    EXPECT_EQ(before.positions_world[v], scene.positions_world[v] - glm::vec3(is_floor ? 0 : 2, 0, 0));
  }
  EXPECT_NE(before.hash, scene.hash);
  EXPECT_EQ(scene_at(scene, 0, kHeight_px).hash, scene.hash);
  scene.motion.object_step_world = {5, 0, 0};
  EXPECT_EQ(scene_at(scene, 4, kHeight_px).bounds_world.max.x,
            21.0);  // no part is left out of the scene's box
}

std::string error_of(std::string_view motion, const Scene& scene) {
  try {
    standard_motion(motion, scene);
  } catch (const Error& error) {
    return error.what();
  }
  return "no error";
}

TEST(Motion, SaysWhatASceneLacks) {
  const Scene scene = lit_by(rect_light_above({0, 10, 0}, {1, 1}));
  EXPECT_THAT(error_of("object", scene), AllOf(HasSubstr("which object moves"), HasSubstr("object_step")));
  EXPECT_THAT(error_of("script", scene), HasSubstr("says nothing of motion"));
  EXPECT_THAT(error_of("pam", scene), AllOf(HasSubstr("no motion 'pam'"), HasSubstr("'pan'")));
}

Scene parsed(const std::string& motion) {
  const std::string text =
      "[camera]\neye = [0, 3, 10]\nat = [0, 0, 0]\n[[mesh]]\nname = \"floor\"\nshape = \"plane\"\nsize = [4, "
      "4]\n"
      "[[mesh]]\nname = \"box\"\nshape = \"box\"\nsize = [1, 1, 1]\n"
      "[[light]]\ntype = \"disk\"\ncenter = [0, 5, 0]\ndirection = [0, -1, 0]\nradius = 0.3\n";
  return parse_scene(text + motion, "tried.toml", {});
}

std::string script_error(const std::string& motion) {
  try {
    parsed(motion);
  } catch (const Error& error) {
    return error.what();
  }
  return "no error";
}

TEST(Motion, IsReadFromAScene) {
  const Scene scene = parsed(
      "[motion]\ncamera_step = [0.1, 0, 0]\nlight_step = [0, 0, 0.2]\nobject = \"box\"\nobject_step = [0, "
      "0.3, "
      "0]\n");
  EXPECT_EQ(scene.motion.name, "script");
  const Scene before = scene_at(scene, -2, kHeight_px);
  EXPECT_NEAR(before.camera.eye_world.x, -0.2, 1e-12);
  EXPECT_NEAR(before.light().center_world.z, -0.4, 1e-12);
  EXPECT_NE(scene.hash, parsed("").hash);
  EXPECT_EQ(standard_motion("object", scene).object, "box");
  EXPECT_EQ(standard_motion("object", scene).camera_step_world, glm::dvec3(0.0));
}

TEST(Motion, SaysWhatIsWrongInAScene) {
  EXPECT_THAT(script_error("[motion]\nobject = \"bx\"\nobject_step = [1, 0, 0]\n"),
              AllOf(HasSubstr("called 'bx'"), HasSubstr("'box'")));
  EXPECT_THAT(script_error("[motion]\nobject_step = [1, 0, 0]\n"), HasSubstr("add 'object'"));
  EXPECT_THAT(script_error("[motion]\nsun_step_deg = 1\n"), HasSubstr("no sun to turn"));
  EXPECT_THAT(script_error("[motion]\n"), HasSubstr("moves nothing"));
  EXPECT_THAT(script_error("[motion]\ncamera = [1, 0, 0]\n"), HasSubstr("'camera'"));
}

}  // namespace
}  // namespace umbrameter
