// SPDX-License-Identifier: Apache-2.0
// Without these a pbrt scene could stand askew, lose a light or its holes without a word, or take the program down.
#include "foreign_folder.h"

#include <gmock/gmock.h>
#include <glm/geometric.hpp>

namespace umbrameter {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;

const std::string kRightHanded = "Scale -1 1 1\nCamera \"perspective\"\nWorldBegin\n";
const std::string kTriangle =
    "Shape \"trianglemesh\" \"point3 P\" [ 0 0 0  1 0 0  0 1 0 ] \"integer indices\" [ 0 1 2 ]\n";
const std::string kSquare =
    "Shape \"bilinearmesh\" \"point3 P\" [ -1 -1 0  1 -1 0  -1 1 0  1 1 0 ] \"integer indices\" [ 0 1 2 3 ]";

class Pbrt : public ForeignTest {
 protected:
  MeshData world(const std::string& text) { return mesh("x.pbrt", kRightHanded + text); }
  Scene lit(const std::string& text) const { return load("x.pbrt", kRightHanded + text + "\n" + kTriangle); }
};

TEST_F(Pbrt, TransformsMultiplyFromTheRight) {
  const MeshData moved = world("Translate 1 0 0\nScale 2 2 2\n" + kTriangle);
  EXPECT_EQ(moved.positions[1], glm::dvec3(3, 0, 0));
  const MeshData columns = world("ConcatTransform [ 1 0 0 0  2 1 0 0  0 0 1 0  5 6 7 1 ]\n" + kTriangle);
  EXPECT_EQ(columns.positions[2], glm::dvec3(5 + 2, 6 + 1, 7)) << "a shear, column by column";
  const MeshData named = world(
      "Translate 0 0 4\nCoordinateSystem \"up\"\nIdentity\nTranslate 9 9 9\nCoordSysTransform \"up\"\n" +
      kTriangle);
  EXPECT_EQ(named.positions[0], glm::dvec3(0, 0, 4));
  const MeshData blocks = world(
      "AttributeBegin\nTranslate 9 0 0\nAttributeEnd\nTransformBegin\nTranslate 9 0 0\n"
      "TransformEnd\nTransform [ 1 0 0 0  0 1 0 0  0 0 1 0  0 3 0 1 ]\n" +
      kTriangle);
  EXPECT_EQ(blocks.positions[0], glm::dvec3(0, 3, 0));
}

TEST_F(Pbrt, ObjectsStandWhereTheirInstancesAre) {
  const std::string object = "ObjectBegin \"tree\"\nTranslate 0 1 0\nShape \"sphere\"\nObjectEnd\n";
  const MeshData two =
      world(object + "ObjectInstance \"tree\"\nTranslate 10 0 0\nScale 2 2 2\nObjectInstance \"tree\"\n");
  EXPECT_TRUE(two.repeated.empty());
  EXPECT_NEAR(bounds_of(two).max.y, 4.0, 1e-12);
  EXPECT_NEAR(bounds_of(two).max.x, 12.0, 1e-12);
  std::string many = object;
  for (int i = 0; i < 40; ++i) many += "ObjectInstance \"tree\"\nTranslate 3 0 0\n";
  const MeshData forest = world(many);
  ASSERT_EQ(forest.repeated.size(), 1u) << "kept once";
  EXPECT_EQ(forest.repeated[0].world_from_mesh[39][3], glm::dvec4(117, 1, 0, 1));
  EXPECT_EQ(error_of("x.pbrt", object + "ObjectInstance \"tre\""),
            "x.pbrt:5: no object is called 'tre' (did you mean 'tree'?)");
}

TEST_F(Pbrt, ShapesThatShineAreLights) {
  const auto shining = [&](const std::string& shape) {
    return lit("AttributeBegin\nAreaLightSource \"diffuse\"\n" + shape + "\nAttributeEnd");
  };
  const Scene patch = shining("Translate 0 3 0\nRotate 90 1 0 0\nScale 1 2 1\n" + kSquare);
  EXPECT_EQ(patch.triangles.size(), 1u);
  EXPECT_EQ(patch.light().type, LightType::rect);
  EXPECT_EQ(patch.light().direction_world, glm::dvec3(0, -1, 0));
  EXPECT_EQ(patch.light().center_world, glm::dvec3(0, 3, 0));
  EXPECT_EQ(patch.light().size_world.x * patch.light().size_world.y, 8.0);
  EXPECT_EQ(shining("ReverseOrientation\n" + kSquare).light().direction_world, glm::dvec3(0, 0, -1));
  EXPECT_EQ(shining("Scale -1 1 1\n" + kSquare).light().direction_world, glm::dvec3(0, 0, 1))
      << "outside stays outside";
  const std::string against = " \"normal N\" [ 0 0 -1  0 0 -1  0 0 -1  0 0 -1 ]";
  EXPECT_EQ(shining(kSquare + against).light().direction_world, glm::dvec3(0, 0, -1)) << "normals count more";
  EXPECT_EQ(shining("Shape \"disk\" \"float radius\" 2 \"float height\" 1").light().center_world,
            glm::dvec3(0, 0, 1));
  const Scene triangle = shining(kTriangle);
  EXPECT_EQ(triangle.light().type, LightType::sun);
  EXPECT_THAT(triangle.warnings, Contains(HasSubstr("1 shape that shines is no rectangle, disk or sphere")));
  const Scene both = lit("AreaLightSource \"diffuse\" \"bool twosided\" true\n" + kSquare +
                         "\nAttributeBegin\n" + kSquare + "\nAttributeEnd\nWorldBegin");
  EXPECT_EQ(both.lights.size(), 2u);
  EXPECT_THAT(both.warnings, Contains("x.pbrt: 2 lights shine to one side, not to both"));
}

TEST_F(Pbrt, LampsFollowTheRulesOfGltf) {
  const Scene scene =
      lit("Translate 1 0 0\nLightSource \"point\" \"point3 from\" [ 0 2 0 ]\n"
          "LightSource \"spot\" \"point3 from\" [ 0 4 0 ] \"point3 to\" [ 0 0 0 ]\nLightSource \"distant\"\n"
          "LightSource \"infinite\" \"rgb L\" [ 1 1 1 ]");
  ASSERT_EQ(scene.lights.size(), 3u);
  EXPECT_EQ(scene.lights[0].center_world, glm::dvec3(1, 2, 0));
  EXPECT_EQ(scene.lights[0].radius_world, 0.05);
  EXPECT_EQ(scene.lights[1].type, LightType::disk);
  EXPECT_EQ(scene.lights[1].direction_world, glm::dvec3(0, -1, 0));
  EXPECT_EQ(scene.lights[2].direction_world, glm::dvec3(0, 0, 1)) << "pbrt's default: from the origin to +z";
  EXPECT_THAT(scene.warnings, Contains("x.pbrt: 1 light of type 'infinite' is left out"));
}

TEST_F(Pbrt, AlphaMakesHoles) {
  write_grey("leaf.png", 2, {255, 0, 128, 188});
  const auto texture = [](const std::string& more) {
    return "Texture \"leaf\" \"float\" \"imagemap\" \"string filename\" \"leaf.png\" " + more + "\n";
  };
  const std::string card = kSquare + " \"texture alpha\" \"leaf\"\n";
  const MeshData leaf = world(texture("") + card);
  EXPECT_THAT(leaf.masks.at(0).bits, ElementsAre(0b0110u))
      << "rows from below; 128 is a fifth of white, 188 half";
  EXPECT_EQ(leaf.cutouts.at(0).uv, (std::array{glm::vec2(0, 0), glm::vec2(1, 0), glm::vec2(1, 1)}))
      << "v = 0 is the picture's lowest row";
  EXPECT_THAT(world(texture("\"string encoding\" \"linear\"") + card).masks.at(0).bits, ElementsAre(0b0111u));
  EXPECT_THAT(world(texture("\"bool invert\" true") + card).masks.at(0).bits, ElementsAre(0b1001u));
  EXPECT_EQ(world(texture("\"float uscale\" 3 \"float vdelta\" 0.5") + card).cutouts.at(0).uv[2],
            glm::vec2(3, 1.5));
  EXPECT_EQ(world(kSquare + " \"float alpha\" 0\n").cutouts.size(), 2u);
  EXPECT_TRUE(world(kSquare + " \"float alpha\" 0.7\n").cutouts.empty());
  EXPECT_THAT(warnings_,
              ElementsAre("x.pbrt: 1 mesh of an even alpha is solid from 0.5 on, and a hole below"));
  EXPECT_EQ(error_of("x.pbrt", texture("") + kSquare + " \"texture alpha\" \"laef\""),
            "x.pbrt:2: no texture is called 'laef' (did you mean 'leaf'?)");
}

TEST_F(Pbrt, WhatIsNotReadIsCounted) {
  world(
      "Option \"bool disablepixeljitter\" true\nColorSpace \"srgb\"\nMediumInterface \"\" \"fog\"\n"
      "Material \"interface\"\n" +
      kTriangle + "Material \"dielectric\" \"float eta\" 1.5\n" + kTriangle +
      "MakeNamedMaterial \"m\" \"string type\" \"diffuse\"\nNamedMaterial \"m\"\nShape \"curve\"\nShape "
      "\"curve\"\n"
      "Shape \"sphere\" \"float zmax\" 0.5\nAttribute \"shape\" \"float radius\" 2\n"
      "Shape \"bilinearmesh\" \"point3 P\" [ 0 0 0  1 0 0  0 1 0  1 1 1 ]\n");
  EXPECT_THAT(warnings_, ElementsAre("x.pbrt: 1 shape without a surface is left out",
                                     "x.pbrt: 1 shape of glass is solid",
                                     "x.pbrt: 2 shapes of type 'curve' are left out",
                                     "x.pbrt: 1 part of a shape of type 'sphere' is left out",
                                     "x.pbrt: 1 default by 'Attribute' of type 'shape' is left out",
                                     "x.pbrt: 1 bilinear patch that is not flat is two triangles"));
}

TEST_F(Pbrt, FilesIncludeOthers) {
  write("geometry.pbrt", "Translate 1 0 0\n" + kTriangle);
  const MeshData mesh = world("Include \"geometry.pbrt\"\nTranslate 1 0 0\n" + kTriangle);
  EXPECT_EQ(mesh.triangles.size(), 2u);
  EXPECT_EQ(mesh.positions[3], glm::dvec3(2, 0, 0));
  EXPECT_THAT(mesh.side_files, ElementsAre(folder_.path() / "geometry.pbrt"));
}

TEST_F(Pbrt, BadFilesAreSentences) {
  const auto error = [&](const std::string& text) { return error_of("x.pbrt", text); };
  EXPECT_EQ(error(""), "x.pbrt: the file has no triangles");
  EXPECT_EQ(error("\nHello"), "x.pbrt:2: 'Hello' is no statement of pbrt");
  EXPECT_EQ(error("Translate 1 0"), "x.pbrt:1: the file ends within a statement");
  EXPECT_EQ(error("Translate 1 nan 0"), "x.pbrt:1: 'nan' is no finite number");
  EXPECT_EQ(error("Scale 1e300 1 1 Scale 1e300 1 1"), "x.pbrt:1: the transform is not finite");
  EXPECT_EQ(error("LookAt 0 0 0 0 0 0 0 1 0"), "x.pbrt:1: a vector has no direction");
  EXPECT_EQ(error("Scale 0 1 1 Camera \"perspective\""), "x.pbrt:1: the camera's transform has no inverse");
  EXPECT_EQ(error("AttributeBegin"), "x.pbrt:1: a block has no end");
  EXPECT_EQ(error("AttributeEnd"), "x.pbrt:1: 'AttributeEnd' has no begin");
  EXPECT_EQ(error("Shape \"sphere"), "x.pbrt:1: a string has no end");
  EXPECT_EQ(error("Shape \"sphere\" \"float radius\" [ 1"),
            "x.pbrt:1: the values of parameter 'float radius' have no end");
  EXPECT_EQ(
      error(
          "Shape \"trianglemesh\" \"point3 P\" [ 0 0 0 1 0 0 0 1 0 ] \"integer indices\" [ 0 1 1000000000 ]"),
      "x.pbrt:1: 'indices' holds 1000000000, but there are 3 vertices");
  EXPECT_EQ(error("Shape \"trianglemesh\" \"point3 P\" [ 0 0 0 1 0 0 0 1 ]"),
            "x.pbrt:1: parameter 'P' has 8 numbers, no multiple of 3");
  EXPECT_EQ(error("Shape \"plymesh\" \"string filename\" \"gone.ply\""),
            "x.pbrt:1: file 'gone.ply' is not there");
  write("packed.ply.gz", "x");
  EXPECT_EQ(error("Shape \"plymesh\" \"string filename\" \"packed.ply.gz\""),
            "x.pbrt:1: 'packed.ply.gz' does not end in '.ply' (unpack it first)");
  write("b.pbrt", "Include \"x.pbrt\"");
  EXPECT_EQ(error("Include \"b.pbrt\""), "b.pbrt:1: file 'x.pbrt' includes itself");
  EXPECT_EQ(error("Include \"gone.pbrt\""), "x.pbrt:1: the included file 'gone.pbrt' is not there");
  std::string deep;
  for (int i = 0; i < 20'000; ++i) deep += "AttributeBegin ";
  EXPECT_EQ(error(deep), "x.pbrt:1: blocks are nested deeper than 10,000");
}

}  // namespace
}  // namespace umbrameter
