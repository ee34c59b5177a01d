// SPDX-License-Identifier: Apache-2.0
// Without these: a bad scene file could load as something else, or fail with a message that helps nobody.
#include "scene_text.h"

#include <gmock/gmock.h>

#include <vector>

namespace umbrameter {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

std::string error_of(const SceneText& text) {
  return message_of([&] { text.parse(); });
}

std::string error_of_camera(const std::string& camera) {
  return error_of({.camera = camera});
}
std::string error_of_mesh(const std::string& mesh) {
  return error_of({.mesh = mesh});
}
std::string error_of_light(const std::string& light) {
  return error_of({.light = light});
}

TEST(SceneErrors, CameraOnItsTarget) {
  EXPECT_EQ(error_of_camera("eye = [1, 2, 3]\nat = [1, 2, 3]"),
            "x.toml:3:6: [camera]: the camera stands on its target (1, 2, 3) ('eye' and 'at' must differ)");
}

TEST(SceneErrors, UpAlongTheView) {
  EXPECT_EQ(
      error_of_camera("eye = [0, 5, 0]\nat = [0, 0, 0]\nup = [0, 2, 0]"),
      "x.toml:4:6: [camera]: 'up' = (0, 1, 0) is parallel to the view direction (for a view straight down "
      "choose up = [0, 0, -1])");
  EXPECT_THAT(error_of_camera("eye = [0, 5, 0]\nat = [0, 0, 0]"),
              HasSubstr("is parallel to the view direction"));
}

TEST(SceneErrors, FieldOfViewOutsideZeroTo180) {
  for (const std::string fov : {"0", "180", "-10", "361.5"}) {
    EXPECT_EQ(error_of_camera("eye = [0, 5, 1]\nat = [0, 0, 0]\nfov_deg = " + fov),
              "x.toml:4:11: [camera]: 'fov_deg' = " + fov +
                  " must lie between 0 and 180 degrees (it is the vertical field of view)");
  }
}

TEST(SceneErrors, NearPlaneNotPositive) {
  EXPECT_EQ(error_of_camera("eye = [0, 5, 1]\nat = [0, 0, 0]\nnear = 0"),
            "x.toml:4:8: [camera]: 'near' = 0 must be a length above 0 (at least 1e-09, at most 1e+09)");
}

TEST(SceneErrors, UnknownKeyNamesTheNearest) {
  EXPECT_THAT(error_of_camera("eye = [0, 5, 1]\nat = [0, 0, 0]\nfov_dge = 3"),
              StartsWith("x.toml:4:11: [camera] has an unknown key 'fov_dge' (did you mean 'fov_deg'?"));
  EXPECT_THAT(error_of_mesh("shape = \"box\"\nsize = [1, 1, 1]\ntranslat = [0, 0, 0]"),
              HasSubstr("[[mesh]] has an unknown key 'translat' (did you mean 'translate'?"));
  EXPECT_THAT(error_of({.top = "titel = \"a\"\n"}), HasSubstr("unknown key 'titel' (did you mean 'title'?"));
}

TEST(SceneErrors, UnknownKeyOfAMeshFileIsFoundBeforeTheFile) {
  EXPECT_THAT(error_of_mesh("file = \"missing.obj\"\nscael = 2"), HasSubstr("did you mean 'scale'?"));
}

TEST(SceneErrors, WrongTypes) {
  EXPECT_THAT(error_of_camera("eye = \"here\"\nat = [0, 0, 0]"),
              HasSubstr("'eye' must be an array, not a text"));
  EXPECT_THAT(error_of_camera("eye = [0, 0]\nat = [0, 0, 0]"), HasSubstr("'eye' must hold 3 numbers, not 2"));
  EXPECT_THAT(error_of_mesh("shape = 3"), HasSubstr("'shape' must be a text, not an integer"));
  EXPECT_THAT(error_of_mesh("shape = \"box\"\nsize = 1"), HasSubstr("'size' must be an array"));
}

TEST(SceneErrors, NumbersThatAreNotFinite) {
  EXPECT_THAT(error_of_camera("eye = [0, nan, 1]\nat = [0, 0, 0]"), HasSubstr("not a finite number"));
  EXPECT_THAT(error_of_light("type = \"disk\"\ncenter = [0, 1, 0]\ndirection = [0, -1, 0]\nradius = inf"),
              HasSubstr("'radius' is inf, which is not a finite number"));
}

TEST(SceneErrors, CoordinatesOutOfRange) {
  EXPECT_EQ(error_of_camera("eye = [0, 0, 2e9]\nat = [0, 0, 0]"),
            "x.toml:2:7: [camera]: 'eye' holds 2000000000; coordinates must stay within 1e+09");
  EXPECT_THAT(
      error_of_mesh("shape = \"plane\"\nsize = [1e9, 1e9]\nscale = 100"),
      HasSubstr("mesh 'plane' has a vertex at (-50000000000, 0, 50000000000); coordinates must stay within"));
}

TEST(SceneErrors, LightWithoutArea) {
  EXPECT_EQ(error_of_light("type = \"rect\"\ncenter = [0, 4, 0]\ndirection = [0, -1, 0]\nsize = [1, 0]"),
            "x.toml:11:8: [[light]]: 'size' = 0 must be a length above 0 (at least 1e-09, at most 1e+09)");
  EXPECT_THAT(error_of_light("type = \"sphere\"\ncenter = [0, 4, 0]\ndirection = [0, -1, 0]\nradius = -1"),
              HasSubstr("'radius' = -1 must be a length above 0"));
  EXPECT_EQ(error_of_light("type = \"sun\"\ndirection = [0, -1, 0]\nangular_diameter_deg = 0"),
            "x.toml:10:24: [[light]]: 'angular_diameter_deg' = 0 must lie between 1e-6 and 90 degrees (the "
            "real sun "
            "has 0.53)");
}

TEST(SceneErrors, LightWithoutDirection) {
  EXPECT_EQ(error_of_light("type = \"sun\"\ndirection = [0, 0, 0]\nangular_diameter_deg = 1"),
            "x.toml:9:13: [[light]]: 'direction' = (0, 0, 0) has no direction");
  EXPECT_THAT(error_of_light("type = \"disk\"\ncenter = [0, 4, 0]\nradius = 1"),
              HasSubstr("'direction' or 'at' is missing ('direction' points away from the light"));
  EXPECT_THAT(error_of_light("type = \"disk\"\ncenter = [0, 4, 0]\nradius = 1\nat = [0, 4, 0]"),
              HasSubstr("'at' = (0, 4, 0) is the light's centre"));
  EXPECT_THAT(error_of_light(
                  "type = \"disk\"\ncenter = [0, 4, 0]\nradius = 1\nat = [0, 0, 0]\ndirection = [0, -1, 0]"),
              HasSubstr("give either 'direction' or 'at', not both"));
  EXPECT_THAT(error_of_light("type = \"sun\"\nangular_diameter_deg = 1\nat = [0, 0, 0]"),
              HasSubstr("a sun has no place, so no 'at' (use 'direction')"));
}

TEST(SceneErrors, TangentAlongTheDirection) {
  EXPECT_THAT(error_of_light("type = \"disk\"\ncenter = [0, 4, 0]\nradius = 1\ndirection = [0, -1, 0]\n"
                             "tangent = [0, 3, 0]"),
              HasSubstr("'tangent' = (0, 1, 0) is parallel to the light's direction"));
}

TEST(SceneErrors, UnknownLightTypeNamesTheNearest) {
  EXPECT_THAT(error_of_light("type = \"disc\"\ncenter = [0, 4, 0]"),
              HasSubstr("'type' = 'disc' is not known here (did you mean 'disk'?"));
}

TEST(SceneErrors, TwoLightsOfOneName) {
  const std::string sun = "name = \"sky\"\ntype = \"sun\"\ndirection = [0, -1, 0]\nangular_diameter_deg = 1";
  EXPECT_EQ(error_of_light(sun + "\n[[light]]\n" + sun),
            "x.toml:12:1: two lights are called 'sky' (give each a 'name' of its own)");
  EXPECT_EQ(error_of_light("name = \"\"\ntype = \"sun\"\ndirection = [0, -1, 0]\nangular_diameter_deg = 1"),
            "x.toml:8:8: [[light]]: the light's 'name' is empty");
}

TEST(SceneErrors, NothingToSee) {
  const std::string camera = "[camera]\neye = [0, 2, 5]\nat = [0, 0, 0]\n";
  EXPECT_THAT(message_of([&] { parse_scene(camera, "x.toml", {}); }),
              HasSubstr("there is no light (add a [[light]] table)"));
  EXPECT_THAT(message_of([&] {
                parse_scene(camera +
                                "[[light]]\ntype = \"sun\"\ndirection = [0, -1, 0]\n"
                                "angular_diameter_deg = 1\n",
                            "x.toml", {});
              }),
              HasSubstr("there is no mesh (add a [[mesh]] table)"));
  EXPECT_THAT(message_of([&] { parse_scene("", "x.toml", {}); }), HasSubstr("needs the key 'camera'"));
}

TEST(SceneErrors, MeshWithoutOrWithTwoSources) {
  for (const std::string mesh : {"name = \"a\"", "shape = \"box\"\nfile = \"a.obj\""}) {
    EXPECT_THAT(error_of_mesh(mesh),
                HasSubstr("a mesh needs either 'file' or 'shape' (file = \"x.obj\" or shape"));
  }
}

TEST(SceneErrors, UnknownShapeNamesTheNearest) {
  EXPECT_EQ(error_of_mesh("shape = \"shpere\""),
            "x.toml:5:9: [[mesh]]: 'shape' = 'shpere' is not known here (did you mean 'sphere'?)");
}

TEST(SceneErrors, ShapeLimits) {
  EXPECT_THAT(error_of_mesh("shape = \"sphere\"\nradius = 1\nsegments = 3"),
              HasSubstr("'segments' = 3 must be between 4 and 1024"));
  EXPECT_THAT(error_of_mesh("shape = \"comb\"\ncount = 3\nperiod = 1\nbar = 1\nlength = 1"),
              HasSubstr("'period' = 1 leaves no gap between bars 1 wide"));
  EXPECT_THAT(error_of_mesh("shape = \"colonnade\"\ncount = 3\nspacing = 1\nradius = 0.5\nheight = 1"),
              HasSubstr("'spacing' = 1 makes columns of radius 0.5 overlap"));
  EXPECT_THAT(error_of_mesh("shape = \"stairs\"\ncount = 9999999999\nsize = [1, 1, 1]"),
              HasSubstr("'count' = 9999999999 must be between 1 and 10000"));
}

TEST(SceneErrors, FlatteningScale) {
  EXPECT_THAT(error_of_mesh("shape = \"box\"\nsize = [1, 1, 1]\nscale = [1, 0, 1]"),
              HasSubstr("'scale' holds 0, which flattens the mesh"));
}

TEST(SceneErrors, TooManyTriangles) {
  // 17 spheres of 1024 meridians: 17 * 1024 * 2 * 511 = 17,790,976 triangles.
  SceneText text;
  text.mesh = "shape = \"sphere\"\nradius = 1\nsegments = 1024";
  const std::string sphere = text.mesh;
  for (int i = 1; i < 17; ++i) text.mesh += "\n[[mesh]]\n" + sphere;
  EXPECT_EQ(
      error_of(text),
      "x.toml:68:1: with mesh 'sphere' the scene has 17790976 triangles; at most 16777215 can be told apart");
}

TEST(SceneErrors, MissingMeshFileSaysWhereItWasSought) {
  SceneText text;
  text.mesh = "file = \"bunny.obj\"";
  EXPECT_EQ(message_of([&] { text.parse("scenes/x.toml"); }),
            "scenes/x.toml:5:8: [[mesh]]: mesh file 'bunny.obj' is not in 'scenes' (give the folder of the "
            "models with "
            "--assets DIR or UMBRAMETER_ASSETS)");
  EXPECT_THAT(message_of([&] { text.parse("x.toml", {.assets = "models", .library = {}}); }),
              HasSubstr("mesh file 'bunny.obj' is not in '.' and 'models'"));
}

TEST(SceneErrors, UnknownMeshFormat) {
  EXPECT_EQ(
      error_of_mesh("file = \"bunny.step\""),
      "x.toml:5:8: [[mesh]]: mesh file 'bunny.step' has an unknown format ('.obj', '.obj.zst', '.gltf', "
      "'.glb', '.fbx', '.dae', '.ply', '.stl', '.xml' and '.pbrt' are read)");
}

TEST(SceneErrors, MissingSceneFile) {
  EXPECT_THAT(message_of([] { load_scene("no/such.toml", {}); }), StartsWith("no/such.toml: "));
}

TEST(SceneErrors, SyntaxErrorHasItsPlace) {
  EXPECT_THAT(error_of_camera("eye = [0, 1"), StartsWith("x.toml:"));
}

}  // namespace
}  // namespace umbrameter
