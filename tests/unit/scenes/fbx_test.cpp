// SPDX-License-Identifier: Apache-2.0
// Without these a scene from a modeller could lose its lights, lie on its side, or be a hundred times too large.
#include "core/files.h"
#include "scene_text.h"
#include "scenes/import_scene.h"
#include "tests/support/temporary_folder.h"

#include <gmock/gmock.h>

#include <glm/geometric.hpp>

namespace umbrameter {
namespace {

using testing::Contains;
using testing::HasSubstr;

// Centimetres, z up: a plate of 2 x 1 m half a metre up, a camera that looks along x, a point, a sun and an area.
const std::string kHead = R"(; FBX 7.4.0 project file
FBXHeaderExtension:  {
 FBXHeaderVersion: 1003
 FBXVersion: 7400
}
GlobalSettings:  {
 Version: 1000
 Properties70:  {
  P: "UpAxis", "int", "Integer", "",2
  P: "UpAxisSign", "int", "Integer", "",1
  P: "FrontAxis", "int", "Integer", "",1
  P: "FrontAxisSign", "int", "Integer", "",-1
  P: "CoordAxis", "int", "Integer", "",0
  P: "CoordAxisSign", "int", "Integer", "",1
  P: "UnitScaleFactor", "double", "Number", "",1
 }
}
Objects:  {
)";
const std::string kObjects = R"( Geometry: 10, "Geometry::plate", "Mesh" {
  Vertices: *12 {
   a: 0,0,0,200,0,0,200,100,0,0,100,0
  }
  PolygonVertexIndex: *4 {
   a: 0,1,2,-4
  }
 }
 Model: 20, "Model::plate", "Mesh" {
  Version: 232
  Properties70:  {
   P: "Lcl Translation", "Lcl Translation", "", "A",0,0,50
  }
 }
 NodeAttribute: 30, "NodeAttribute::eye", "Camera" {
  Properties70:  {
   P: "AspectWidth", "double", "Number", "",200
   P: "AspectHeight", "double", "Number", "",100
   P: "FieldOfView", "FieldOfView", "", "A",90
  }
 }
 Model: 31, "Model::eye", "Camera" {
  Version: 232
  Properties70:  {
   P: "Lcl Translation", "Lcl Translation", "", "A",-300,50,100
  }
 }
 NodeAttribute: 40, "NodeAttribute::bulb", "Light" {
  Properties70:  {
   P: "LightType", "enum", "", "",0
  }
 }
 Model: 41, "Model::bulb", "Light" {
  Version: 232
  Properties70:  {
   P: "Lcl Translation", "Lcl Translation", "", "A",100,50,300
   P: "radius", "double", "Number", "A+U",0.25
  }
 }
 NodeAttribute: 42, "NodeAttribute::sky", "Light" {
  Properties70:  {
   P: "LightType", "enum", "", "",1
  }
 }
 Model: 43, "Model::sky", "Light" {
  Version: 232
  Properties70:  {
   P: "Lcl Rotation", "Lcl Rotation", "", "A",90,0,0
  }
 }
 NodeAttribute: 44, "NodeAttribute::panel", "Light" {
  Properties70:  {
   P: "LightType", "enum", "", "",3
  }
 }
 Model: 45, "Model::panel", "Light" {
  Version: 232
  Properties70:  {
   P: "Lcl Translation", "Lcl Translation", "", "A",0,0,400
   P: "Lcl Rotation", "Lcl Rotation", "", "A",90,0,0
   P: "size", "Vector3D", "Vector", "A+U",1.5,0.5,0
  }
 }
)";
const std::string kConnections = R"( C: "OO",10,20
 C: "OO",20,0
 C: "OO",30,31
 C: "OO",31,0
 C: "OO",40,41
 C: "OO",41,0
 C: "OO",42,43
 C: "OO",43,0
 C: "OO",44,45
 C: "OO",45,0
)";
// The plate goes 4 m along x within 2 s.
const std::string kSlide = R"( AnimationStack: 50, "AnimStack::slide", "" {
  Properties70:  {
   P: "LocalStop", "KTime", "Time", "",92372316000
  }
 }
 AnimationLayer: 51, "AnimLayer::layer", "" {
 }
 AnimationCurveNode: 52, "AnimCurveNode::T", "" {
  Properties70:  {
   P: "d|X", "Number", "", "A",0
   P: "d|Y", "Number", "", "A",0
   P: "d|Z", "Number", "", "A",50
  }
 }
 AnimationCurve: 53, "AnimCurve::", "" {
  KeyVer: 4009
  KeyTime: *2 {
   a: 0,92372316000
  }
  KeyValueFloat: *2 {
   a: 0,400
  }
 }
)";
const std::string kSlideConnections = R"( C: "OO",51,50
 C: "OO",52,51
 C: "OP",52,20, "Lcl Translation"
 C: "OP",53,52, "d|X"
)";

std::string fbx(const std::string& objects = {}, const std::string& connections = {}) {
  return kHead + kObjects + objects + "}\nConnections:  {\n" + kConnections + connections + "}\n";
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return at == std::string::npos ? text : text.replace(at, from.size(), to);
}

class Fbx : public testing::Test {
 protected:
  Scene load(const std::string& text, const std::optional<AnimationTime>& at = {}) const {
    write_file_atomically(path(), text);
    SceneSearch search;
    search.at = at;
    return load_scene(path(), search);
  }
  std::filesystem::path path() const { return folder_.path() / "x.fbx"; }

  TemporaryFolder folder_;
};

void expect_near(const glm::dvec3& p, const glm::dvec3& wanted) {
  EXPECT_NEAR(glm::distance(p, wanted), 0.0, 1e-6) << p.x << " " << p.y << " " << p.z;
}

TEST_F(Fbx, StandsInMetresWithYUp) {
  const Scene scene = load(fbx());
  ASSERT_EQ(scene.triangles.size(), 2u);
  expect_near(scene.bounds_world.min, {0, 0.5, -1});
  expect_near(scene.bounds_world.max, {2, 0.5, 0});
  expect_near(triangle_normal_world(scene, 0), {0, 1, 0});
}

TEST_F(Fbx, CamerasAreReadAsTheyStand) {
  const Scene scene = load(fbx());
  expect_near(scene.camera.eye_world, {-3, 1, -0.5});
  expect_near(glm::normalize(scene.camera.at_world - scene.camera.eye_world), {1, 0, 0});
  expect_near(scene.camera.up_world, {0, 0, -1});
  EXPECT_NEAR(scene.camera.vertical_fov_deg, 53.13010235415598, 1e-4)
      << "90 degrees across, twice as wide as high";
  EXPECT_THAT(load(replaced(fbx(), "\"\", \"A\",90\n", "\"\", \"A\",190\n")).warnings,
              Contains("x.fbx: camera 'eye' has a field of view of 190 degrees and is left out"));
}

TEST_F(Fbx, LightsAreReadWithTheSizesThatTheirNodesHave) {
  const Scene scene = load(fbx());
  ASSERT_EQ(scene.lights.size(), 3u);
  EXPECT_EQ(scene.lights[0].name, "bulb");
  EXPECT_EQ(scene.lights[0].type, LightType::sphere);
  EXPECT_EQ(scene.lights[0].radius_world, 0.25);
  expect_near(scene.lights[0].center_world, {1, 3, -0.5});
  EXPECT_EQ(scene.lights[1].type, LightType::sun);
  expect_near(scene.lights[1].direction_world, {0, -1, 0});
  EXPECT_THAT(scene.warnings,
              Contains("x.fbx: light 'sky' has no angular diameter in degrees; 0.53 is taken"));
  EXPECT_EQ(scene.lights[2].type, LightType::rect);
  EXPECT_EQ(scene.lights[2].size_world, glm::dvec2(1.5, 0.5));
  expect_near(scene.lights[2].center_world, {0, 4, 0});
  expect_near(scene.lights[2].direction_world, {0, -1, 0});
  expect_near(scene.lights[2].tangent_world, {1, 0, 0});
}

TEST_F(Fbx, WhatCannotBeReadIsSaid) {
  const std::string spot =
      replaced(fbx(), "\"LightType\", \"enum\", \"\", \"\",0", "\"LightType\", \"enum\", \"\", \"\",2");
  EXPECT_EQ(load(spot).lights[0].type, LightType::disk);
  EXPECT_THAT(load(spot).warnings, Contains("x.fbx: spot 'bulb' is a disk without the edges of its cone"));
  const std::string unsized_panel = replaced(fbx(), "\"size\", \"Vector3D\"", "\"width\", \"Vector3D\"");
  EXPECT_EQ(load(unsized_panel).lights[2].type, LightType::disk);
  EXPECT_THAT(load(unsized_panel).warnings,
              Contains("x.fbx: light 'panel' has no radius in metres; 0.05 is taken"));
}

TEST_F(Fbx, OtherUnitsAndAxes) {
  const Scene metres = load(replaced(fbx(), "\"UnitScaleFactor\", \"double\", \"Number\", \"\",1",
                                     "\"UnitScaleFactor\", \"double\", \"Number\", \"\",100"));
  expect_near(metres.bounds_world.max, {200, 50, 0});
  expect_near(metres.lights[0].center_world, {100, 300, -50});
  EXPECT_EQ(metres.lights[0].radius_world, 0.25) << "its own property is in metres";
  std::string y_up =
      replaced(fbx(), "\"UpAxis\", \"int\", \"Integer\", \"\",2", "\"UpAxis\", \"int\", \"Integer\", \"\",1");
  y_up = replaced(y_up, "\"FrontAxis\", \"int\", \"Integer\", \"\",1",
                  "\"FrontAxis\", \"int\", \"Integer\", \"\",2");
  expect_near(load(replaced(y_up, "\"FrontAxisSign\", \"int\", \"Integer\", \"\",-1",
                            "\"FrontAxisSign\", \"int\", \"Integer\", \"\",1"))
                  .bounds_world.max,
              {2, 1, 0.5});
}

TEST_F(Fbx, NodesMoveInStraightLinesBetweenKeys) {
  const std::string text = fbx(kSlide, kSlideConnections);
  const Scene half = load(text, AnimationTime{0.5});
  expect_near(half.bounds_world.min, {1, 0.5, -1});
  ASSERT_EQ(half.animated.size(), 1u);
  EXPECT_EQ(half.animated[0].animation, "slide");
  EXPECT_THAT(half.warnings,
              Contains("x.fbx: between the keys of animation 'slide' everything moves in straight lines"));
  expect_near(load(text, AnimationTime{9}).bounds_world.min, {4, 0.5, -1});
  EXPECT_THAT(load(text, AnimationTime{9}).warnings,
              Contains("x.fbx: 9 s lies beyond the last key of animation 'slide' at 2 s, which holds"));
  EXPECT_NE(half.hash, load(text).hash);
  EXPECT_THAT(load(text).warnings, Contains(HasSubstr("1 animation is not shown ('slide')")));
  EXPECT_THAT(message_of([&] { load(fbx(), AnimationTime{1}); }),
              HasSubstr("x.fbx: it cannot be shown at 1 s"));
}

TEST_F(Fbx, ImportedScenesAreTheSame) {
  write_file_atomically(path(), fbx(kSlide, kSlideConnections));
  const AnimationTime at{0.5, "slide"};
  const ImportedScene imported = import_file(path(), at);
  EXPECT_THAT(imported.toml, HasSubstr("file = \"x.fbx\"\ntime = 0.5\nanimation = \"slide\"\n"));
  const Scene scene = parse_scene(imported.toml, folder_.path() / "x.toml", {});
  SceneSearch search;
  search.at = at;
  EXPECT_EQ(scene.hash, load_scene(path(), search).hash);
}

}  // namespace
}  // namespace umbrameter
