// SPDX-License-Identifier: Apache-2.0
// Without these: one model could have different shadows depending on which program wrote the file.
#include "core/files.h"
#include "scene_text.h"
#include "tests/support/temporary_folder.h"

#include <gmock/gmock.h>

#include <glm/geometric.hpp>

namespace umbrameter {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

struct Dialect {
  std::string name;
  std::string obj;
  std::vector<std::string> warnings = {};
};

const std::string kCorners =
    "v -0.5 0 0.5\nv 0.5 0 0.5\nv 0.5 1 0.5\nv -0.5 1 0.5\nv -0.5 0 -0.5\nv 0.5 0 -0.5\nv 0.5 1 -0.5\nv -0.5 "
    "1 "
    "-0.5\n";
const std::string kFaces = "f 1 2 3 4\nf 6 5 8 7\nf 5 1 4 8\nf 2 6 7 3\nf 4 3 7 8\nf 5 6 2 1\n";

/// `text` with every `from` replaced by `to`.
std::string with(std::string text, const std::string& from, const std::string& to) {
  for (size_t at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size()))
    text.replace(at, from.size(), to);
  return text;
}

/// "f a b c d" with `end` after each index.
std::string faces_with(const std::string& end) {
  std::string text = with(with(kFaces, " ", end + " "), "f" + end, "f");
  return with(text, "\n", end + "\n");
}

const std::vector<Dialect> kDialects = {
    {"negative indices",
     kCorners + "f -8 -7 -6 -5\nf -3 -4 -1 -2\nf -4 -8 -5 -1\nf -7 -3 -2 -6\nf -5 -6 -2 -1\nf -4 "
                "-3 -7 -8\n"},
    {"carriage returns", with(kCorners + kFaces, "\n", "\r")},
    {"Windows line ends", with(kCorners + kFaces, "\n", "\r\n")},
    {"tabs", with(kCorners + kFaces, " ", "\t")},
    {"blanks everywhere", with(with(kCorners + kFaces, " ", "   "), "\n", "  \n\n  ")},
    {"continued lines", kCorners + with(kFaces, " 3", " \\\n 3")},
    {"continued normal", kCorners + "vn 0 1 \\\n 0\n" + kFaces},
    {"byte order mark", "\xEF\xBB\xBF# a\n" + kCorners + kFaces},
    {"inline comments", with(kCorners + "l 1 3\ng box\n" + kFaces, "\n", " # and so on\n")},
    {"material without a library",
     "mtllib gone.mtl\n" + kCorners + "usemtl gone\n" + kFaces,
     {"m.obj: the material library 'gone.mtl' is not there, so no material has holes"}},
    {"flat normals", kCorners + "vn 0 0 1\nvn 0 0 -1\nvn -1 0 0\nvn 1 0 0\nvn 0 1 0\nvn 0 -1 0\n"
                                "f 1//1 2//1 3//1 4//1\nf 6//2 5//2 8//2 7//2\nf 5//3 1//3 4//3 8//3\n"
                                "f 2//4 6//4 7//4 3//4\nf 4//5 3//5 7//5 8//5\nf 5//6 6//6 2//6 1//6\n"},
    {"slashes at the end",
     kCorners + faces_with("//"),
     {"m.obj: 24 corners with slashes at their ends are read without them (the first in line 9)"}},
    {"faces of one and two corners",
     kCorners + "f 1\nf 1 2\n" + kFaces,
     {"m.obj: 2 faces of less than three corners are left out (the first in line 9)"}},
    {"repeated corners",
     kCorners + with(kFaces, " 4\n", " 4 4\n"),
     {"m.obj: 1 corner is left out, being where its neighbour is (line 9)"}},
    {"normals that are not finite",
     kCorners + "vn nan nan nan\n" + faces_with("//1"),
     {"m.obj: 1 normal that is not finite is not used (line 9)",
      "m.obj: 12 of 12 triangles without usable normals: shaded flat"}},
    {"normals of which half are not finite, the others along or across their faces",
     kCorners +
         "vn 0 0 1\nvn nan nan nan\nf 1//2 2//2 3//2 4//2\nf 6//1 5//1 8//1 7//1\nf 5//2 1//2 4//2 8//2\n"
         "f 2//1 6//1 7//1 3//1\nf 4//2 3//2 7//2 8//2\nf 5//1 6//1 2//1 1//1\n",
     {"m.obj: 1 normal that is not finite is not used (line 10)",
      "m.obj: 10 of 12 triangles without usable normals: shaded flat"}},
};

class ObjDialects : public testing::Test {
 protected:
  Scene load(const std::string& obj, const std::string& file = "m.obj") {
    write_file_atomically(folder_.path() / file, obj);
    const SceneText text{.mesh = "shape = \"plane\"\nsize = [20, 20]\n[[mesh]]\nfile = \"" + file + "\""};
    return text.parse(folder_.path() / "x.toml");
  }

  TemporaryFolder folder_;
};

TEST_F(ObjDialects, AllGiveTheSameScene) {
  const Scene base = load(kCorners + kFaces);
  EXPECT_EQ(base.triangles.size(), 14u);
  EXPECT_THAT(base.warnings, IsEmpty());
  for (const Dialect& dialect : kDialects) {
    SCOPED_TRACE(dialect.name);
    const Scene scene = load(dialect.obj);
    EXPECT_EQ(scene.triangles.size(), 14u);
    EXPECT_EQ(scene.hash, base.hash);
    EXPECT_EQ(scene.warnings, dialect.warnings);
  }
  EXPECT_EQ(load(kCorners + kFaces, "MODEL.OBJ").hash, base.hash);
}

TEST_F(ObjDialects, ConcaveFacesWithRepeatedCornersKeepTheirArea) {
  const std::string repeated =
      "v 0 1 0\nv 3 1 0\nv 3 1 -2\nv 4 1 -2\nv 4 1 -2\nv 4 1 -4\nv 2 1 -4\nv 2 1 -5\nv 2 1 -5\nv 0 1 -5\n";
  const Scene scene = load(repeated + "f 1 2 3 4 5 6 7 8 9 10\n");
  double area = 0.0, signed_area = 0.0;
  for (size_t t = 2; t < scene.triangles.size(); ++t) {  // after the plane
    const glm::uvec3& index = scene.triangles[t];
    const glm::dvec3 a = scene.positions_world[index.x];
    const glm::dvec3 cross = glm::cross(glm::dvec3(scene.positions_world[index.y]) - a,
                                        glm::dvec3(scene.positions_world[index.z]) - a);
    area += glm::length(cross) / 2;
    signed_area += cross.y / 2;
  }
  EXPECT_EQ(area, 16.0);
  EXPECT_EQ(signed_area, 16.0) << "no triangle is turned over";
  EXPECT_THAT(scene.warnings,
              ElementsAre("m.obj: 2 corners are left out, being where their neighbours are (the first "
                          "in line 11)"));
}

}  // namespace
}  // namespace umbrameter
