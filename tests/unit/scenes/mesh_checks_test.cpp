// SPDX-License-Identifier: Apache-2.0
// Without these: triangles that no two renderers agree about would stay, or good ones would go.
#include "core/files.h"
#include "scene_text.h"
#include "scenes/light_enclosure.h"
#include "tests/support/temporary_folder.h"

#include <gmock/gmock.h>

#include <glm/geometric.hpp>

namespace umbrameter {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

class MeshChecks : public testing::Test {
 protected:
  Scene load(const std::string& obj, const std::string& more_mesh = {}) {
    write_file_atomically(folder_.path() / "m.obj", obj);
    return SceneText{.mesh = "file = \"m.obj\"" + more_mesh}.parse(folder_.path() / "x.toml");
  }
  TemporaryFolder folder_;
};

const std::string kSquare = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

TEST_F(MeshChecks, TrianglesOfZeroAreaAreDroppedAndCounted) {
  // Repeated index, repeated position (vertex 5 = vertex 1), three points in a row (vertex 6 halves the edge
  // 1-2).
  const Scene scene = load(kSquare + "v 0 0 0\nv 0.5 0 0\nf 1 2 3\nf 1 1 2\nf 1 5 3\nf 1 6 2\nf 1 3 4\n");
  EXPECT_EQ(scene.triangles.size(), 2u);
  EXPECT_THAT(scene.warnings, ElementsAre("m.obj: dropped 3 triangles of zero area"));
}

TEST_F(MeshChecks, ThinTrianglesStay) {
  EXPECT_EQ(load(kSquare + "v 0.5 1e-12 0\nf 1 2 3\nf 1 2 5\n").triangles.size(), 2u);
}

TEST_F(MeshChecks, DuplicatesAreDroppedInAnyOrderAndOrientation) {
  // -0 equals 0: vertex 5 is vertex 1.
  const Scene scene = load(kSquare + "v -0 0 -0\nf 1 2 3\nf 2 3 1\nf 3 2 1\nf 5 2 3\nf 1 3 4\n");
  ASSERT_EQ(scene.triangles.size(), 2u);
  EXPECT_THAT(scene.warnings, ElementsAre("m.obj: dropped 3 duplicates"));
  EXPECT_EQ(triangle_normal_world(scene, 0), glm::dvec3(0, 0, 1)) << "the first of them stays";
}

TEST_F(MeshChecks, ZeroAreaAndDuplicatesShareASentence) {
  EXPECT_THAT(load(kSquare + "f 1 2 3\nf 1 2 3\nf 1 1 3\n").warnings,
              ElementsAre("m.obj: dropped 1 triangle of zero area, 1 duplicate"));
}

TEST_F(MeshChecks, DuplicatesBetweenMeshesAreChargedToTheLater) {
  // Of the square's two triangles, the copy's first is the same; the other diagonal gives a new triangle.
  write_file_atomically(folder_.path() / "copy.obj", kSquare + "f 1 2 3\nf 2 3 4\n");
  const Scene scene = load(kSquare + "f 1 2 3 4\n", "\n[[mesh]]\nfile = \"copy.obj\"");
  EXPECT_EQ(scene.triangles.size(), 3u);
  EXPECT_THAT(scene.warnings, ElementsAre("copy.obj: dropped 1 duplicate"));
}

TEST_F(MeshChecks, PartsShrinkWithTheirTriangles) {
  const Scene scene = load(kSquare + "usemtl a\nf 1 1 2\nusemtl b\nf 1 2 3\nf 1 2 3\nusemtl c\nf 1 3 4\n");
  ASSERT_EQ(scene.parts.size(), 2u);
  EXPECT_EQ(scene.parts[0].name, "m/b");
  EXPECT_EQ(scene.parts[0].triangle_count, 1u);
  EXPECT_EQ(scene.parts[1].name, "m/c");
  EXPECT_EQ(scene.parts[1].first_triangle, 1u);
}

TEST_F(MeshChecks, VerticesWithoutTrianglesDoNotCount) {
  const Scene scene = load("v 9 9 9\n" + kSquare + "f 2 3 4\n");
  EXPECT_EQ(scene.positions_world.size(), 3u);
  EXPECT_EQ(scene.bounds_world.max, glm::dvec3(1, 1, 0));
}

TEST_F(MeshChecks, MeshThatLosesEverythingIsAnError) {
  const std::string message = message_of([&] { load(kSquare + "f 1 1 2\nf 1 2 2\n"); });
  EXPECT_THAT(message, testing::HasSubstr(
                           "x.toml:4:1: mesh 'm' is empty: 2 triangles of zero area had to be dropped"));
}

TEST_F(MeshChecks, MeshThatStandsWhereAnotherDoesIsDroppedWithAWarning) {
  const Scene scene = load(kSquare + "f 1 2 3 4\n", "\n[[mesh]]\nname = \"again\"\nfile = \"m.obj\"");
  EXPECT_EQ(scene.triangles.size(), 2u);
  EXPECT_THAT(scene.warnings, testing::Contains("m.obj: dropped 2 duplicates; nothing of it is left"));
  EXPECT_EQ(scene.parts.size(), 1u);
}

TEST_F(MeshChecks, FlatMeshBesideASmoothOneGetsItsGeometricNormals) {
  const Scene scene =
      load(kSquare + "f 1 2 3 4\n", "\n[[mesh]]\nshape = \"sphere\"\nradius = 1\nsmooth = true");
  ASSERT_EQ(scene.normals_world.size(), scene.positions_world.size());
  for (uint32_t t = 0; t < 2; ++t) {
    for (int corner = 0; corner < 3; ++corner) {
      EXPECT_EQ(scene.normals_world[scene.triangles[t][corner]], glm::vec3(0, 0, 1));
    }
  }
  EXPECT_TRUE(load(kSquare + "f 1 2 3 4\n").normals_world.empty());
}

std::vector<std::string> warnings_of(const std::string& mesh, const std::string& center,
                                     const std::string& eye) {
  SceneText text;
  text.camera = "eye = " + eye + "\nat = [0, 0.1, 0]";
  text.mesh = mesh;
  text.light = "name = \"lamp\"\ntype = \"sphere\"\nradius = 0.1\ndirection = [0, -1, 0]\ncenter = " + center;
  return text.parse().warnings;
}

TEST(LightEnclosure, LightInsideABoxIsReported) {
  EXPECT_THAT(
      warnings_of("name = \"crate\"\nshape = \"box\"\nsize = [2, 2, 2]", "[0.1, 0.7, 0.2]", "[0, 1, 9]"),
      ElementsAre("light 'lamp' seems to be inside 'crate'"));
}

TEST(LightEnclosure, LightAndCameraInOneRoomAreNot) {
  EXPECT_THAT(warnings_of("shape = \"box\"\nsize = [2, 2, 2]", "[0.1, 0.7, 0.2]", "[0.3, 1, 0.5]"),
              IsEmpty());
}

TEST(LightEnclosure, LightOutsideIsNot) {
  EXPECT_THAT(warnings_of("shape = \"box\"\nsize = [2, 2, 2]", "[0.1, 2.7, 0.2]", "[0, 1, 9]"), IsEmpty());
  EXPECT_THAT(warnings_of("shape = \"stairs\"\ncount = 3\nsize = [2, 1, 1]", "[0, 2.5, -0.5]", "[0, 1, 9]"),
              IsEmpty());
}

TEST(LightEnclosure, LightOnASurfaceIsReported) {
  const std::string ceiling = "name = \"ceiling\"\nshape = \"plane\"\nsize = [4, 4]\ntranslate = [0, 2.1, 0]";
  EXPECT_THAT(warnings_of(ceiling, "[0.5, 2.1, 0.25]", "[0, 1, 9]"),
              ElementsAre("the centre of light 'lamp' lies on 'ceiling'"));
  EXPECT_THAT(warnings_of(ceiling, "[0.5, 2.0999, 0.25]", "[0, 1, 9]"),
              ElementsAre("light 'lamp' is pierced by 'ceiling'"));  // its rim
}

}  // namespace
}  // namespace umbrameter
