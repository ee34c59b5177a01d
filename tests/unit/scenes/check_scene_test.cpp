// SPDX-License-Identifier: Apache-2.0
// Without these, scenes that show nothing, or something else than their author thinks, would pass as fine.
#include "scenes/check_scene.h"

#include "scene_text.h"
#include "scenes/light_body.h"

#include <gmock/gmock.h>

namespace umbrameter {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

const std::string kBox = "name = \"box\"\nshape = \"box\"\nsize = [1, 1, 1]";

std::vector<std::string> found_in(const SceneText& text) {
  return check_scene(text.parse());
}

TEST(CheckScene, AFineSceneHasNoWarning) {
  EXPECT_THAT(found_in({}), IsEmpty());
  EXPECT_THAT(found_in({.mesh = kBox}), IsEmpty());
}

TEST(CheckScene, LightsThatFaceAway) {
  EXPECT_THAT(
      found_in({.light = "type = \"rect\"\ncenter = [0, 4, 0]\ndirection = [0, 1, 0]\nsize = [1, 1]"}),
      ElementsAre("light 'rect' faces away: all of the scene is behind it"));
  EXPECT_THAT(found_in({.light = "type = \"sun\"\ndirection = [0, 1, 0.5]\nangular_diameter_deg = 1"}),
              ElementsAre("sun 'sun' shines upwards: 'direction' points away from it"));
  EXPECT_THAT(found_in({.light = "type = \"sphere\"\ncenter = [0, 4, 0]\ndirection = [0, 1, 0]\nradius = 1"}),
              IsEmpty());
}

TEST(CheckScene, CamerasThatSeeNothing) {
  EXPECT_THAT(found_in({.camera = "eye = [0, 1, 5]\nat = [0, 1, 10]", .mesh = kBox}),
              ElementsAre("the camera sees nothing"));
  EXPECT_THAT(found_in({.camera = "eye = [0, 1, 5]\nat = [40, 1, 5]\nfov_deg = 20", .mesh = kBox}),
              ElementsAre("the camera sees nothing"));
  // The plane passes below the camera and fills half of its view, though all its corners lie outside.
  EXPECT_THAT(found_in({.camera = "eye = [0, 1, 0]\nat = [0, 0.9, 1]",
                        .mesh = "shape = \"plane\"\nsize = [900, 900]"}),
              IsEmpty());
}

TEST(CheckScene, SizesThatAreNoMetres) {
  EXPECT_THAT(found_in({.camera = "eye = [320, 240, 440]\nat = [0, 40, 0]",
                        .mesh = "shape = \"plane\"\nsize = [600, 600]"}),
              ElementsAre(HasSubstr("the camera is 579.7 m from its target: are these metres?")));
  EXPECT_THAT(found_in({.camera = "eye = [0, 0.005, 0.01]\nat = [0, 0, 0]"}),
              ElementsAre(HasSubstr("m from its target")));
}

TEST(CheckScene, OpenAndInvertedMeshes) {
  EXPECT_THAT(found_in({.mesh = kBox + "\nscale = [1, 1, 1]"}), IsEmpty());
  Scene scene = SceneText{.mesh = "name = \"ball\"\nshape = \"sphere\"\nradius = 1\nsegments = 16"}.parse();
  const Scene whole = scene;
  for (glm::uvec3& t : scene.triangles.edit()) std::swap(t.x, t.y);
  EXPECT_THAT(check_scene(scene), ElementsAre("'ball' is inside out: its triangles face inwards"));
  scene.camera.eye_world = {0, 0.1, 0};
  scene.camera.at_world = {1, 0.1, 0};
  EXPECT_THAT(check_scene(scene), IsEmpty()) << "a room";
  scene = whole;
  scene.triangles.edit().pop_back();
  --scene.parts.back().triangle_count;
  EXPECT_THAT(
      check_scene(scene),
      ElementsAre(testing::MatchesRegex("'ball' is not closed: 3 of [0-9]+ edges have one triangle")));
}

Light light_of(LightType type) {
  Light light;
  light.type = type;
  light.size_world = {2.0, 1.0};  // x along x, y along z
  light.radius_world = 1.0;
  return light;
}

TEST(LightBody, TrianglesThatReachIntoIt) {
  struct Case {
    glm::dvec3 a, b, c;
    bool rect, disk, sphere;
  };
  // Lights lie at the origin, the flat ones in the plane y = 0.
  const std::vector<Case> cases = {
      {{0, -1, 0}, {0.1, 1, 0}, {0, 1, 0.1}, true, true, true},  // through the middle
      {{5, -1, 1}, {-5, -1, 1}, {0, 5, -5}, true, true, true},   // wider than everything, through the middle
      {{-5, 0, -5}, {5, 0, -5}, {0, 0, 5}, false, false, true},  // in the plane
      {{0.8, -1, 0.4}, {0.8, 1, 0.4}, {0.8, 1, 0.45}, true, true, true},     // inside both outlines
      {{0.8, -1, 0.55}, {0.8, 1, 0.55}, {0.8, 1, 0.58}, false, true, true},  // beyond the rect's side
      {{0, 0.5, 0}, {0.2, 0.5, 0}, {0, 0.5, 0.2}, false, false, true},       // above, in the ball
      {{-5, 1.0, -5}, {5, 1.0, -5}, {0, 1.0, 5}, false, false, false},       // touches the ball
  };
  for (size_t i = 0; i < cases.size(); ++i) {
    const Case& one = cases[i];
    EXPECT_EQ(pierces(light_of(LightType::rect), one.a, one.b, one.c), one.rect) << i;
    EXPECT_EQ(pierces(light_of(LightType::disk), one.a, one.b, one.c), one.disk) << i;
    EXPECT_EQ(pierces(light_of(LightType::sphere), one.a, one.b, one.c), one.sphere) << i;
    EXPECT_FALSE(pierces(light_of(LightType::sun), one.a, one.b, one.c)) << i;
  }
}

TEST(LightBody, ALampInAWallIsAWarningOfTheScene) {
  const std::string wall = "name = \"wall\"\nshape = \"box\"\nsize = [0.1, 3, 6]";
  const auto warnings = [&](const std::string& center) {
    return SceneText{.camera = "eye = [-3, 2.5, 4]\nat = [-0.5, 0.3, 0]",
                     .mesh = wall,
                     .light = "type = \"sphere\"\ncenter = [" + center + "]\nat = [0.2, 0, 0]\nradius = 0.25"}
        .parse()
        .warnings;
  };
  EXPECT_THAT(warnings("0.2, 1.2, 0"), ElementsAre("light 'sphere' is pierced by 'wall'"));
  EXPECT_THAT(warnings("0.31, 1.2, 0"), IsEmpty());
}

}  // namespace
}  // namespace umbrameter
