// SPDX-License-Identifier: Apache-2.0
// Without these a mesh from a scanner, a printer or a modeller could stand askew, in another unit, or lose its holes.
#include "scenes/assimp/assimp_mesh.h"

#include "core/files.h"
#include "scene_text.h"
#include "tests/support/temporary_folder.h"

#include <gmock/gmock.h>

#include <glm/geometric.hpp>

namespace umbrameter {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

/// Twice the area of all triangles, as a vector: also their side.
glm::dvec3 area_of(const MeshData& mesh) {
  glm::dvec3 sum(0.0);
  for (const glm::uvec3& t : mesh.triangles)
    sum += glm::cross(mesh.positions[t.y] - mesh.positions[t.x], mesh.positions[t.z] - mesh.positions[t.x]);
  return sum;
}

class Assimp : public testing::Test {
 protected:
  MeshData load(const std::string& name, const std::string& text, const MeshFilter& filter = {}) {
    write_file_atomically(folder_.path() / name, text);
    return load_assimp_mesh(folder_.path() / name, filter, {}, warnings_);
  }

  TemporaryFolder folder_;
  std::vector<std::string> warnings_;
};

// A plate of 2 x 1 in the xy plane as a node three times as large, 5 to the right, in centimetres.
const std::string kCollada = R"(<?xml version="1.0"?>
<COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1">
<asset><unit name="centimeter" meter="0.01"/><up_axis>Y_UP</up_axis></asset>
<library_materials><material id="m" name="leaf"><instance_effect url="#e"/></material></library_materials>
<library_effects><effect id="e"><profile_COMMON><technique sid="t"><lambert/></technique></profile_COMMON></effect></library_effects>
<library_geometries><geometry id="g" name="plate"><mesh>
<source id="p"><float_array id="pa" count="12">0 0 0 2 0 0 2 1 0 0 1 0</float_array>
<technique_common><accessor source="#pa" count="4" stride="3"><param name="X" type="float"/><param name="Y" type="float"/><param name="Z" type="float"/></accessor></technique_common></source>
<vertices id="v"><input semantic="POSITION" source="#p"/></vertices>
<polylist count="1" material="m"><input semantic="VERTEX" source="#v" offset="0"/><vcount>4</vcount><p>0 1 2 3</p></polylist>
</mesh></geometry></library_geometries>
<library_visual_scenes><visual_scene id="s"><node id="n" name="board"><matrix>3 0 0 5 0 3 0 0 0 0 3 0 0 0 0 1</matrix>
<instance_geometry url="#g"><bind_material><technique_common><instance_material symbol="m" target="#m"/></technique_common></bind_material></instance_geometry></node></visual_scene></library_visual_scenes>
<scene><instance_visual_scene url="#s"/></scene></COLLADA>)";

TEST_F(Assimp, ColladaNodesStandInMetres) {
  const MeshData mesh = load("x.dae", kCollada);
  ASSERT_EQ(mesh.triangles.size(), 2u);
  const glm::dvec3 area = area_of(mesh);
  EXPECT_NEAR(area.z, 2.0 * 6.0 * 3.0 * 1e-4, 1e-9) << "6 x 3 cm, facing +z";
  EXPECT_NEAR(glm::length(area), area.z, 1e-12);
  double right = 0.0;
  for (const glm::dvec3& p : mesh.positions) right = std::max(right, p.x);
  EXPECT_NEAR(right, 0.11, 1e-6);
  EXPECT_EQ(mesh.parts[0].name, "leaf");
  EXPECT_THAT(warnings_, IsEmpty());
}

TEST_F(Assimp, NamesChooseWhatIsRead) {
  EXPECT_EQ(load("x.dae", kCollada, {{"leaf"}, {}}).triangles.size(), 2u);
  EXPECT_THAT(message_of([&] { load("x.dae", kCollada, {{}, {"board"}}); }), HasSubstr("has no triangles"));
  EXPECT_THAT(message_of([&] { load("x.dae", kCollada, {{"leav"}, {}}); }), HasSubstr("'leav'"));
}

TEST_F(Assimp, PlyQuadsAndStlTrianglesAreReadAsTheyStand) {
  const MeshData ply =
      load("x.PLY",
           "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\n"
           "property float z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n"
           "0 0 0\n2 0 0\n2 1 0\n0 1 0\n4 0 1 2 3\n");
  EXPECT_EQ(ply.triangles.size(), 2u);
  EXPECT_NEAR(area_of(ply).z, 4.0, 1e-6);
  const MeshData stl =
      load("x.stl",
           "solid one\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 2 0 0\nvertex 0 1 0\n"
           "endloop\nendfacet\nendsolid one\n");
  EXPECT_EQ(stl.triangles.size(), 1u);
  EXPECT_NEAR(area_of(stl).z, 2.0, 1e-6);
}

TEST_F(Assimp, ScenesReferToThem) {
  write_file_atomically(folder_.path() / "x.dae", kCollada);
  const SceneText text{.mesh = "file = \"x.dae\"\nscale = 100\nrotate_deg = -90\naxis = [1, 0, 0]"};
  const Scene scene = text.parse(folder_.path() / "x.toml");
  EXPECT_EQ(scene.triangles.size(), 2u);
}

TEST_F(Assimp, BadFilesGetASentence) {
  for (const char* name : {"x.fbx", "x.dae", "x.ply", "x.stl"}) {
    EXPECT_THAT(message_of([&] { load(name, ""); }), HasSubstr(name)) << name;
    EXPECT_THAT(message_of([&] { load(name, "nothing that anybody reads"); }), HasSubstr(name)) << name;
  }
  EXPECT_THAT(message_of([&] { load("x.dae", kCollada.substr(0, 900)); }), HasSubstr("cannot be read"));
  EXPECT_THAT(
      message_of([&] {
        load("x.ply",
             "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
             "element face 1\nproperty list uchar int vertex_indices\nend_header\nnan 0 0\n2 0 0\n2 1 0\n3 0 "
             "1 2\n");
      }),
      HasSubstr("x.ply"));
}

}  // namespace
}  // namespace umbrameter
