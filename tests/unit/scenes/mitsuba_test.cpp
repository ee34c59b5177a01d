// SPDX-License-Identifier: Apache-2.0
// Without these a Mitsuba scene could lose a shape, a shear or a light without a word, or take the program down.
#include "foreign_folder.h"

#include <gmock/gmock.h>
#include <glm/geometric.hpp>

namespace umbrameter {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;

std::string scene_of(const std::string& inside) {
  return "<scene version=\"3.0.0\">\n" + inside + "\n</scene>\n";
}
std::string area(const std::string& type, const std::string& to_world, const std::string& more = "") {
  return "<shape type=\"" + type + "\">" + more + "<transform name=\"to_world\">" + to_world +
         "</transform><emitter type=\"area\"/></shape>";
}

class Mitsuba : public ForeignTest {
 protected:
  Light light(const std::string& shape) const { return load("x.xml", scene_of(kCube + shape)).lights.at(0); }

  const std::string kCube = "<shape type=\"cube\"/>";
};

TEST_F(Mitsuba, StepsOfATransformFollowEachOther) {
  const Scene sheared = load("x.xml", scene_of("<shape type=\"rectangle\"><transform name=\"to_world\">"
                                               "<matrix value=\"1 2 0 5  0 1 0 0  0 0 1 0  0 0 0 1\"/>"
                                               "<scale value=\"1, 1, 2\"/></transform></shape>"));
  EXPECT_EQ(sheared.positions_world[0], glm::vec3(-1 - 2 + 5, -1, 0));
  EXPECT_EQ(sheared.positions_world[2], glm::vec3(1 + 2 + 5, 1, 0));
  const Scene turned =
      load("x.xml", scene_of("<shape type=\"rectangle\"><transform name=\"to_world\">"
                             "<translate x=\"3\"/><rotate z=\"2\" angle=\"90\"/></transform></shape>"));
  EXPECT_EQ(turned.positions_world[1], glm::vec3(1, 4, 0)) << "first moved, then turned";
}

TEST_F(Mitsuba, MirroredShapesKeepTheirOutside) {
  const Scene scene =
      load("x.xml", scene_of("<shape type=\"cube\"><transform name=\"to_world\"><scale x=\"-1\"/>"
                             "</transform></shape>"));
  for (uint32_t t = 0; t < scene.triangles.size(); ++t) {
    const glm::dvec3 p(scene.positions_world[scene.triangles[t].x]);
    EXPECT_GT(glm::dot(triangle_normal_world(scene, t), p), 0.5);
  }
}

TEST_F(Mitsuba, ShapesThatShineAreLights) {
  const Light turned = light(
      area("rectangle", "<rotate y=\"1\" angle=\"90\"/>", "<boolean name=\"flip_normals\" value=\"true\"/>"));
  EXPECT_LT(glm::distance(turned.direction_world, glm::dvec3(-1, 0, 0)), 1e-12);
  const Light disk = light(area("disk", "<scale x=\"-2\" y=\"2\"/><translate y=\"3\"/>"));
  EXPECT_EQ(disk.radius_world, 2.0);
  EXPECT_EQ(disk.direction_world, glm::dvec3(0, 0, 1)) << "mirrored, it still shines to +z";
  const Scene oval = load("x.xml", scene_of(kCube + area("disk", "<scale x=\"4\" y=\"1\"/>")));
  EXPECT_NEAR(oval.light().radius_world, 2.0, 1e-12);
  EXPECT_THAT(oval.warnings, Contains(HasSubstr("1 ellipse that shines is a round one of the same size")));
  const Scene skewed =
      load("x.xml", scene_of(area("rectangle", "<matrix value=\"1 1 0 0 0 1 0 0 0 0 1 0 0 0 0 1\"/>")));
  EXPECT_EQ(skewed.triangles.size(), 2u) << "a parallelogram stays a mesh";
  EXPECT_EQ(skewed.light().type, LightType::sun);
  EXPECT_THAT(skewed.warnings, Contains(HasSubstr("1 shape that shines is no rectangle, disk or sphere")));
  EXPECT_THAT(skewed.warnings, Contains(HasSubstr("it has no light that is read; a sun stands high")));
  write("quad.obj", "v 0 0 0\nv 2 0 0\nv 2 1 0\nv 0 1 0\nf 1 2 3 4\n");
  const Light quad =
      light(area("obj", "<translate z=\"1\"/>", "<string name=\"filename\" value=\"quad.obj\"/>"));
  EXPECT_EQ(quad.type, LightType::rect);
  EXPECT_EQ(quad.center_world, glm::dvec3(1, 0.5, 1));
  EXPECT_EQ(quad.size_world.x * quad.size_world.y, 2.0);
  EXPECT_EQ(quad.direction_world, glm::dvec3(0, 0, 1));
}

TEST_F(Mitsuba, LampsFollowTheRulesOfGltf) {
  const Scene scene = load("x.xml", scene_of(kCube + R"(
    <emitter type="point" id="bulb"><point name="position" x="1" y="2" z="3"/></emitter>
    <emitter type="spot"><transform name="to_world"><lookat origin="0, 4, 0" target="0, 0, 0" up="0, 0, 1"/></transform></emitter>
    <emitter type="directional"><transform name="to_world"><rotate x="1" angle="90"/></transform></emitter>
    <emitter type="envmap"/><emitter type="envmap"/>)"));
  ASSERT_EQ(scene.lights.size(), 3u);
  EXPECT_EQ(scene.lights[0].name, "bulb");
  EXPECT_EQ(scene.lights[0].type, LightType::sphere);
  EXPECT_EQ(scene.lights[0].radius_world, 0.05);
  EXPECT_EQ(scene.lights[0].center_world, glm::dvec3(1, 2, 3));
  EXPECT_EQ(scene.lights[1].type, LightType::disk);
  EXPECT_EQ(scene.lights[1].direction_world, glm::dvec3(0, -1, 0));
  EXPECT_EQ(scene.lights[2].type, LightType::sun);
  EXPECT_EQ(scene.lights[2].direction_world, glm::dvec3(0, -1, 0));
  EXPECT_THAT(scene.warnings, Contains("x.xml: 2 emitters of type 'envmap' are left out"));
}

TEST_F(Mitsuba, GroupsStandWhereTheirInstancesAre) {
  const std::string group = R"(<shape type="shapegroup" id="trees"><shape type="sphere">
    <transform name="to_world"><translate y="1"/></transform></shape></shape>)";
  const auto instance = [](int x) {
    return "<shape type=\"instance\"><ref id=\"trees\"/><transform name=\"to_world\"><scale "
           "value=\"2\"/><translate x=\"" +
           std::to_string(x) + "\"/></transform></shape>";
  };
  const MeshData two = mesh("x.xml", scene_of(group + instance(0) + instance(10)));
  const size_t sphere = two.triangles.size() / 2;
  EXPECT_TRUE(two.repeated.empty());
  const Bounds3 bounds = bounds_of(two);
  EXPECT_NEAR(bounds.min.y, 0.0, 1e-12);
  EXPECT_NEAR(bounds.max.y, 4.0, 1e-12);
  EXPECT_NEAR(bounds.max.x, 12.0, 1e-12);
  std::string many = group;
  for (int i = 0; i < 40; ++i) many += instance(10 * i);
  const MeshData forest = mesh("x.xml", scene_of(many));
  ASSERT_EQ(forest.repeated.size(), 1u) << "kept once";
  EXPECT_EQ(forest.repeated[0].mesh.triangles.size(), sphere);
  EXPECT_EQ(forest.repeated[0].world_from_mesh.size(), 40u);
  EXPECT_EQ(forest.repeated[0].world_from_mesh[1][3], glm::dvec4(10, 2, 0, 1));
}

TEST_F(Mitsuba, MasksMakeHoles) {
  write_grey("leaf.png", 2, {255, 0, 128, 188});
  const auto masked = [](const std::string& opacity,
                         const std::string& shape = "<shape type=\"rectangle\">") {
    return scene_of("<bsdf type=\"mask\" id=\"leaf\">" + opacity + "<bsdf type=\"diffuse\"/></bsdf>" + shape +
                    "<ref id=\"leaf\"/></shape>");
  };
  const auto bitmap = [](const std::string& more) {
    return "<texture type=\"bitmap\" name=\"opacity\"><string name=\"filename\" value=\"leaf.png\"/>" + more +
           "</texture>";
  };
  const MeshData leaf = mesh("x.xml", masked(bitmap("")));
  ASSERT_EQ(leaf.masks.size(), 1u);
  EXPECT_THAT(leaf.masks[0].bits, ElementsAre(0b0110u))
      << "rows from below; 128 is a fifth of white, 188 half";
  ASSERT_EQ(leaf.cutouts.size(), 2u);
  EXPECT_EQ(leaf.cutouts[0].uv, (std::array{glm::vec2(0, 1), glm::vec2(1, 1), glm::vec2(1, 0)}))
      << "v = 0 is the picture's upper row";
  EXPECT_THAT(mesh("x.xml", masked(bitmap("<boolean name=\"raw\" value=\"true\"/>"))).masks[0].bits,
              ElementsAre(0b0111u));
  const MeshData twice =
      mesh("x.xml", masked(bitmap("<transform name=\"to_uv\"><scale value=\"2\"/></transform>")));
  EXPECT_EQ(twice.cutouts[0].uv[2], glm::vec2(2, -1));
  EXPECT_TRUE(mesh("x.xml", masked("<float name=\"opacity\" value=\"0.7\"/>")).cutouts.empty());
  EXPECT_THAT(warnings_, Contains("x.xml: 1 mask of an even opacity is solid from 0.5 on, and a hole below"));
  EXPECT_THAT(
      mesh("x.xml", masked("<float name=\"opacity\" value=\"0\"/>", "<shape type=\"cube\">")).masks[0].bits,
      ElementsAre(0u));
  write("card.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nvt 0 0\nvt 1 0\nvt 1 1\nf 1/1 2/2 3/3\n");
  const std::string card = "<shape type=\"obj\"><string name=\"filename\" value=\"card.obj\"/>";
  EXPECT_EQ(mesh("x.xml", masked(bitmap(""), card)).cutouts.at(0).uv,
            (std::array{glm::vec2(0, 0), glm::vec2(1, 0), glm::vec2(1, 1)}))
      << "OBJ files' v is turned by default";
  mesh("x.xml", masked(bitmap(""), "<shape type=\"cube\">"));
  EXPECT_THAT(warnings_,
              Contains(HasSubstr("1 mesh has holes, but no texture coordinates that can be used")));
}

TEST_F(Mitsuba, MaterialLibrariesOfMeshesDoNotCount) {
  write("x.mtl", "newmtl gone\nd 0\n");
  write("card.obj", "mtllib x.mtl\nv 0 0 0\nv 1 0 0\nv 1 1 0\nusemtl gone\nf 1 2 3\n");
  EXPECT_TRUE(
      mesh("x.xml", scene_of("<shape type=\"obj\"><string name=\"filename\" value=\"card.obj\"/></shape>"))
          .cutouts.empty());
}

TEST_F(Mitsuba, WhatIsNotReadIsCounted) {
  mesh("x.xml",
       scene_of(
           kCube +
           R"(<shape type="hair"/><shape type="hair"/><shape type="serialized"/><medium type="homogeneous"/>
    <shape type="cube"><bsdf type="null"/></shape><shape type="cube"><bsdf type="dielectric"/></shape><shape type="disk"/>)"));
  EXPECT_THAT(warnings_,
              ElementsAre("x.xml: 2 shapes of type 'hair' are left out",
                          "x.xml: 1 shape of type 'serialized' is left out",
                          "x.xml: 1 object of type 'medium' is left out",
                          "x.xml: 1 shape without a surface (null) is left out",
                          "x.xml: 1 shape of glass is solid", "x.xml: 1 disk is made of triangles"));
}

TEST_F(Mitsuba, IncludesAndParametersAreFilledIn) {
  write("parts/cube.xml",
        scene_of("<default name=\"size\" value=\"7\"/><shape type=\"cube\" id=\"c\">"
                 "<transform name=\"to_world\"><scale value=\"$size\"/></transform></shape>"));
  const MeshData cube =
      mesh("x.xml", scene_of("<default name=\"size\" value=\"3\"/><include filename=\"parts/cube.xml\"/>"));
  EXPECT_EQ(bounds_of(cube).max, glm::dvec3(3)) << "the first default counts";
  EXPECT_THAT(cube.side_files, ElementsAre(folder_.path() / "parts/cube.xml"));
  EXPECT_EQ(error_of("x.xml", scene_of("<shape type=\"$typ\"/>")),
            "x.xml:2: parameter '$typ' has no value (give it one with <default>)");
}

TEST_F(Mitsuba, BadFilesAreSentences) {
  EXPECT_THAT(error_of("x.xml", "<scene>"), HasSubstr("this is no XML: "));
  EXPECT_THAT(error_of("x.xml", ""), HasSubstr("x.xml:1: this is no XML: "));
  EXPECT_EQ(error_of("x.xml", "<html/>"),
            "x.xml:1: this is no Mitsuba scene: its root is <html>, not <scene>");
  EXPECT_EQ(error_of("x.xml", scene_of("")), "x.xml: the file has no triangles");
  write("b.xml", scene_of("<include filename=\"x.xml\"/>"));
  EXPECT_EQ(error_of("x.xml", scene_of("<include filename=\"b.xml\"/>")),
            "b.xml:2: file 'x.xml' includes itself");
  EXPECT_EQ(error_of("x.xml", scene_of("\n<include filename=\"gone.xml\"/>")),
            "x.xml:3: the included file 'gone.xml' is not there");
  EXPECT_EQ(error_of("x.xml",
                     scene_of("<shape type=\"obj\"><string name=\"filename\" value=\"gone.obj\"/></shape>")),
            "x.xml:2: file 'gone.obj' is not there");
  const auto scaled = [](const std::string& step) {
    return scene_of("<shape type=\"cube\"><transform name=\"to_world\">" + step + "</transform></shape>");
  };
  EXPECT_EQ(error_of("x.xml", scaled("<scale value=\"nan\"/>")), "x.xml:2: 'nan' is no finite number");
  EXPECT_EQ(error_of("x.xml", scaled("<scale value=\"1e308\"/><scale value=\"1e308\"/>")),
            "x.xml:2: the transform is not finite");
  EXPECT_EQ(error_of("x.xml", scaled("<matrix value=\"1 2 3\"/>")),
            "x.xml:2: <matrix> has 3 numbers, not 16 or 9");
  EXPECT_EQ(error_of("x.xml", scene_of(kCube + "<shape type=\"instance\"><ref id=\"tre\"/></shape>"
                                               "<shape type=\"shapegroup\" id=\"tree\"/>")),
            "x.xml:2: no object has id 'tre' (did you mean 'tree'?)");
  EXPECT_EQ(
      error_of("x.xml",
               scene_of("<shape type=\"shapegroup\" id=\"g\"><shape type=\"instance\"><ref id=\"g\"/></shape>"
                        "</shape><shape type=\"instance\"><ref id=\"g\"/></shape>")),
      "x.xml:2: a group of shapes holds itself");
  EXPECT_EQ(error_of("x.xml", scene_of("<bsdf type=\"twosided\" id=\"b\"><ref id=\"b\"/></bsdf>"
                                       "<shape type=\"cube\"><ref id=\"b\"/></shape>")),
            "x.xml:2: bsdfs are nested deeper than 16");
  std::string deep = kCube;
  for (int i = 0; i < 100; ++i) deep = "<shape type=\"merge\">" + deep + "</shape>";
  EXPECT_EQ(error_of("x.xml", scene_of(deep)), "x.xml:2: elements are nested deeper than 64");
}

TEST_F(Mitsuba, EntitiesAreNotExpanded) {
  std::string bomb = "<!DOCTYPE scene [<!ENTITY a \"aaaaaaaaaa\">";
  for (char c = 'b'; c <= 'z'; ++c)
    bomb += std::string("<!ENTITY ") + c + " \"&" + static_cast<char>(c - 1) + ";&" +
            static_cast<char>(c - 1) + ";\">";
  EXPECT_EQ(error_of("x.xml", bomb + "]><scene version=\"3.0.0\"><shape type=\"&z;\"/></scene>"),
            "x.xml: the file has no triangles");
}

TEST_F(Mitsuba, DamagedPlyFilesAreSentences) {
  const auto error = [&](const std::string& ply) {
    write("x.ply", ply);
    return error_of("x.xml",
                    scene_of("<shape type=\"ply\"><string name=\"filename\" value=\"x.ply\"/></shape>"));
  };
  const std::string vertices = "property float x\nproperty float y\nproperty float z\n";
  const std::string faces = "element face 1\nproperty list uchar int vertex_indices\nend_header\n";
  const std::string binary = "ply\nformat binary_little_endian 1.0\nelement vertex 3\n" + vertices + faces;
  EXPECT_EQ(error("plx"), "x.ply:1: this is no PLY file: it does not begin with 'ply'");
  EXPECT_EQ(error("ply\nformat ascii 1.0\n"), "x.ply:2: the header has no end");
  EXPECT_EQ(error("ply\nformat ascii 1.0\nelement vertex 1000000000\n" + vertices + "end_header\n0 0 0\n"),
            "x.ply: the file is cut off: its header promises 1000000000 of 'vertex'");
  EXPECT_EQ(error(binary + std::string(35, '\0')),
            "x.ply: the file is cut off: its header promises 3 of 'vertex'");
  EXPECT_EQ(error(binary + std::string(36, '\0') + "\x03" + std::string(11, '\0')),
            "x.ply: the file is cut off: its header promises 1 of 'face'");
  EXPECT_EQ(error("ply\nformat ascii 1.0\nelement vertex 3\n" + vertices + faces +
                  "0 0 0\n1 0 0\n1 1 0\n1000000000 0 1 2\n"),
            "x.ply:13: a list of 'face' is longer than its line");
  EXPECT_THAT(error("ply\nformat ascii 1.0\nelement vertex 3\n" + vertices + faces +
                    "0 0 0\n1 0 0\n1 1 0\n3 0 1 1000000000\n"),
              HasSubstr("x.ply: "));
}

}  // namespace
}  // namespace umbrameter
