// SPDX-License-Identifier: Apache-2.0
// Without these: a scene could be drawn from the wrong place, mirrored, or with a light that looks elsewhere.
#include "scene_text.h"
#include "scenes/seen_from.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <numbers>

namespace umbrameter {
namespace {

Light parse_light(const std::string& light) {
  return SceneText{.light = light}.parse().lights.at(0);
}

TEST(SceneValues, CameraIsReadAsWritten) {
  const Scene scene =
      SceneText{.camera = "eye = [1, 2, 3]\nat = [4, 5, 6.5]\nup = [0, 0, 2]\nfov_deg = 33.5\nnear = 0.25"}
          .parse();
  EXPECT_EQ(scene.camera.eye_world, glm::dvec3(1, 2, 3));
  EXPECT_EQ(scene.camera.at_world, glm::dvec3(4, 5, 6.5));
  EXPECT_EQ(scene.camera.up_world, glm::dvec3(0, 0, 1));
  EXPECT_EQ(scene.camera.vertical_fov_deg, 33.5);
  EXPECT_EQ(scene.camera.near_world, 0.25);
}

TEST(SceneValues, NearPlaneDefaultsToTenThousandthOfTheDiagonal) {
  // A plane of 3 x 4 has the diagonal 5.
  EXPECT_DOUBLE_EQ((SceneText{.mesh = "shape = \"plane\"\nsize = [3, 4]"}.parse().camera.near_world), 5e-4);
}

TEST(SceneValues, NamesAndTexts) {
  const Scene scene = SceneText{.top = "title = \"T\"\ndoc = \"D\"\n"}.parse("folder/room.toml");
  EXPECT_EQ(scene.name, "room");
  EXPECT_EQ(scene.title, "T");
  EXPECT_EQ(scene.doc, "D");
  EXPECT_EQ(scene.source.file, "folder/room.toml");
  EXPECT_EQ(SceneText{}.parse("folder/room.toml").title, "room");
}

TEST(SceneValues, LightFacingDownHasTangentXAndBitangentZ) {
  const Light light =
      parse_light("type = \"rect\"\ncenter = [0, 4, 0]\ndirection = [0, -2, 0]\nsize = [1, 2]");
  EXPECT_EQ(light.name, "rect");
  EXPECT_EQ(light.direction_world, glm::dvec3(0, -1, 0));
  EXPECT_EQ(light.tangent_world, glm::dvec3(1, 0, 0));
  EXPECT_EQ(light.bitangent_world, glm::dvec3(0, 0, 1));
  EXPECT_EQ(light.size_world, glm::dvec2(1, 2));
}

TEST(SceneValues, SunHasHalfItsDiameter) {
  const Light light = parse_light("type = \"sun\"\ndirection = [1, -1, 0]\nangular_diameter_deg = 90");
  EXPECT_EQ(light.type, LightType::sun);
  EXPECT_DOUBLE_EQ(light.half_angle_rad, std::numbers::pi / 4);
}

TEST(SceneValues, AtIsADirectionFromTheCentre) {
  const Light light = parse_light("type = \"sphere\"\ncenter = [1, 4, 0]\nat = [1, 1, 4]\nradius = 0.5");
  EXPECT_EQ(light.direction_world, glm::dvec3(0, -0.6, 0.8));
}

TEST(SceneValues, LightFramesAreOrthonormalForEveryDirection) {
  for (const std::string direction :
       {"[0, 1, 0]", "[0, -1, 1e-9]", "[1, 0, 0]", "[0, 0, -1]", "[-3, 1, 2]", "[1e-4, -1, 0]"}) {
    const Light light =
        parse_light("type = \"disk\"\ncenter = [0, 4, 0]\nradius = 1\ndirection = " + direction);
    const glm::dvec3 t = light.tangent_world;
    const glm::dvec3 b = light.bitangent_world;
    const glm::dvec3 d = light.direction_world;
    EXPECT_NEAR(glm::length(t), 1.0, 1e-12) << direction;
    EXPECT_NEAR(glm::length(b), 1.0, 1e-12) << direction;
    EXPECT_NEAR(glm::dot(t, d), 0.0, 1e-12) << direction;
    EXPECT_NEAR(glm::length(glm::cross(t, b) - d), 0.0, 1e-12) << direction;
  }
}

TEST(SceneValues, TangentIsHorizontalUnlessGiven) {
  const std::string tilted = "type = \"disk\"\ncenter = [0, 4, 0]\nradius = 1\ndirection = [-3, 1, 2]";
  EXPECT_NEAR(parse_light(tilted).tangent_world.y, 0.0, 1e-15);
  const Light given = parse_light(
      "type = \"disk\"\ncenter = [0, 4, 0]\nradius = 1\ndirection = [0, -1, 0]\ntangent = [0, 5, 1]");
  EXPECT_EQ(given.tangent_world, glm::dvec3(0, 0, 1));
}

/// World position of the model point (1, 2, 3): the corner of a box of size 2, 2, 6.
glm::vec3 transformed_corner(const std::string& transform) {
  // Vertex 7 of a box is its (+x, +y, +z) corner.
  return SceneText{.mesh = "shape = \"box\"\nsize = [2, 2, 6]\n" + transform}.parse().positions_world.at(7);
}

TEST(SceneValues, TransformsApplyInTheDocumentedOrder) {
  EXPECT_EQ(transformed_corner(""), glm::vec3(1, 2, 3));
  EXPECT_EQ(transformed_corner("translate = [10, 20, 30]"), glm::vec3(11, 22, 33));
  EXPECT_EQ(transformed_corner("scale = 2\ntranslate = [10, 0, 0]"), glm::vec3(12, 4, 6));
  EXPECT_EQ(transformed_corner("scale = [2, 3, 4]"), glm::vec3(2, 6, 12));
  // About y by +90 degrees: z goes to x, x to -z.
  EXPECT_EQ(transformed_corner("rotate_deg = 90"), glm::vec3(3, 2, -1));
  // About x by -270 = +90 degrees: y goes to z, z to -y.
  EXPECT_EQ(transformed_corner("rotate_deg = -270\naxis = [5, 0, 0]"), glm::vec3(1, -3, 2));
  // z up: (x, y, z) becomes (x, z, -y); then y is scaled.
  EXPECT_EQ(transformed_corner("up = \"z\"\nscale = [1, 10, 1]"), glm::vec3(1, 30, -2));
  EXPECT_EQ(transformed_corner("scale = [2, 1, 1]\nrotate_deg = 90"), glm::vec3(3, 2, -2));
}

TEST(SceneValues, MirroredMeshKeepsItsOutsideOutside) {
  const Scene scene = SceneText{.mesh = "shape = \"plane\"\nsize = [1, 1]\nscale = [-1, 1, 1]"}.parse();
  EXPECT_EQ(triangle_normal_world(scene, 0), glm::dvec3(0, 1, 0));
}

TEST(SceneValues, SmoothNormalsFollowTheInverseTranspose) {
  // The ellipsoid x = 2 u, y = v, z = w of the unit sphere has the normal (u / 2, v, w) normalised.
  const Scene scene =
      SceneText{.mesh = "shape = \"sphere\"\nradius = 1\nsegments = 16\nsmooth = true\nscale = [2, 1, 1]"}
          .parse();
  ASSERT_EQ(scene.normals_world.size(), scene.positions_world.size());
  for (size_t i = 0; i < scene.normals_world.size(); ++i) {
    const glm::vec3 p = scene.positions_world[i];
    const glm::vec3 expected = glm::normalize(glm::vec3(p.x / 4, p.y, p.z));
    EXPECT_LT(glm::length(scene.normals_world[i] - expected), 1e-6f);
  }
}

TEST(SceneValues, PartsAreNamedAndCoverTheTriangles) {
  const Scene scene =
      SceneText{.mesh =
                    "name = \"floor\"\nshape = \"plane\"\nsize = [4, 4]\n[[mesh]]\nshape = \"box\"\n"
                    "size = [1, 1, 1]"}
          .parse();
  ASSERT_EQ(scene.parts.size(), 2u);
  EXPECT_EQ(scene.parts[0].name, "floor");
  EXPECT_EQ(scene.parts[0].triangle_count, 2u);
  EXPECT_EQ(scene.parts[1].name, "box");
  EXPECT_EQ(scene.parts[1].first_triangle, 2u);
  EXPECT_EQ(scene.parts[1].triangle_count, 12u);
  EXPECT_EQ(scene.bounds_world.min, glm::dvec3(-2, 0, -2));
  EXPECT_EQ(scene.bounds_world.max, glm::dvec3(2, 1, 2));
}

TEST(SceneValues, FromElsewhereItIsTheSceneOfAFileThatSaysSo) {
  const Scene written = SceneText{.camera = "eye = [3, 1, 0]\nat = [0, 0, 0]\nfov_deg = 30"}.parse();
  Camera camera = written.camera;
  camera.near_world = 0.0;  // derived anew
  const Scene moved = seen_from(SceneText{}.parse(), camera);
  EXPECT_EQ(moved.hash, written.hash);
  EXPECT_EQ(moved.camera.near_world, written.camera.near_world);
  const Scene own = SceneText{}.parse();
  EXPECT_EQ(seen_from(own, own.camera).hash, own.hash);
}

TEST(SceneValues, HashChangesWithThePictureOnly) {
  const std::string hash = SceneText{}.parse().hash;
  EXPECT_EQ(hash.size(), 32u);
  EXPECT_EQ((SceneText{.top = "title = \"other\"\n"}.parse("y.toml").hash), hash);
  EXPECT_NE((SceneText{.camera = "eye = [0, 2, 5.001]\nat = [0, 0, 0]"}.parse().hash), hash);
  EXPECT_NE((SceneText{.mesh = "shape = \"plane\"\nsize = [4, 4.001]"}.parse().hash), hash);
  EXPECT_NE(
      (SceneText{.light = "type = \"rect\"\ncenter = [0, 4, 0]\ndirection = [0, -1, 0]\nsize = [1, 1.001]"}
           .parse()
           .hash),
      hash);
  EXPECT_NE(
      (SceneText{.light = "type = \"sun\"\nangular_diameter_deg = 1\ndirection = [0, -1, 0]"}.parse().hash),
      hash);
}

}  // namespace
}  // namespace umbrameter
