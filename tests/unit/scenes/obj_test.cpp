// SPDX-License-Identifier: Apache-2.0
// Without these: a broken model could load as a smaller or different one, and its shadows would be measured.
#include "scenes/obj/load_obj.h"

#include "core/files.h"
#include "scene_text.h"
#include "tests/support/temporary_folder.h"

#include <gmock/gmock.h>
#include <zstd.h>

#include <glm/geometric.hpp>

namespace umbrameter {
namespace {

using testing::ElementsAre;
using testing::EndsWith;
using testing::HasSubstr;
using testing::IsEmpty;

const std::string kTriangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
const std::string kSquare = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

std::string compress(const std::string& text) {
  std::string packed(ZSTD_compressBound(text.size()), '\0');
  packed.resize(ZSTD_compress(packed.data(), packed.size(), text.data(), text.size(), 3));
  return packed;
}

class Obj : public testing::Test {
 protected:
  MeshData load(const std::string& bytes, const std::string& name = "m.obj") {
    const std::filesystem::path file = folder_.path() / name;
    write_file_atomically(file, bytes);
    warnings_.clear();
    return load_obj(file, filter_, warnings_);
  }
  /// The message after the folder's name.
  std::string error_of(const std::string& bytes, const std::string& name = "m.obj") {
    const std::string message = message_of([&] { load(bytes, name); });
    const std::string folder = folder_.path().string() + "/";
    EXPECT_EQ(message.substr(0, folder.size()), folder);
    return message.substr(std::min(folder.size(), message.size()));
  }

  TemporaryFolder folder_;
  MeshFilter filter_;
  std::vector<std::string> warnings_;
};

TEST_F(Obj, ReadsATriangle) {
  const MeshData mesh = load("# comment\n\nv 0.5 -1.25e2 .75\nv 1 0 0\nv 0 +1. 0\nf 1 2 3\n");
  EXPECT_THAT(mesh.triangles, ElementsAre(glm::uvec3(0, 1, 2)));
  EXPECT_EQ(glm::vec3(mesh.positions.at(0)), glm::vec3(0.5, -125, 0.75));
  EXPECT_TRUE(mesh.normals.empty());
}

TEST_F(Obj, LineEndsMayBeOfAnySystemAndTheLastMayBeMissing) {
  for (const std::string end : {"\n", "\r\n", "\r"}) {
    EXPECT_EQ(load("v 0 0 0" + end + "v 1 0 0" + end + "v 0 1 0" + end + "f 1 2 3").triangles.size(), 1u);
  }
}

TEST_F(Obj, NegativeIndicesCountBackwards) {
  EXPECT_THAT(load(kTriangle + "f -3 -2 -1\n").triangles, ElementsAre(glm::uvec3(0, 1, 2)));
}

TEST_F(Obj, ReadsCompressedFiles) {
  EXPECT_EQ(load(compress(kTriangle + "f 1 2 3\n"), "m.obj.zst").triangles.size(), 1u);
}

TEST_F(Obj, LinesMayCrossBlocks) {
  // 200,000 vertices are several blocks of 1 MiB; the last one must be read whole.
  std::string text;
  for (int i = 0; i < 200000; ++i) text += fmt::format("v {}.125 0 0\n", i);
  const MeshData mesh = load(compress(text + "v 0 1 0\nf 1 200000 200001\n"), "m.obj.zst");
  ASSERT_EQ(mesh.positions.size(), 200001u);
  for (size_t i = 0; i < 200000; ++i) ASSERT_DOUBLE_EQ(mesh.positions[i].x, static_cast<double>(i) + 0.125);
}

TEST_F(Obj, ConvexPolygonBecomesAFan) {
  EXPECT_THAT(load(kSquare + "f 1 2 3 4\n").triangles, ElementsAre(glm::uvec3(0, 1, 2), glm::uvec3(0, 2, 3)));
}

TEST_F(Obj, ConcavePolygonIsCoveredOnce) {
  // An arrow head: the notch at (1, 1). A fan around the first corner would cover the notch. Area 3.
  for (const int first : {1, 2, 3, 4}) {
    std::string face = "f";
    for (int i = 0; i < 4; ++i) face += fmt::format(" {}", (first - 1 + i) % 4 + 1);
    const MeshData mesh = load("v 0 0 5\nv 3 0 5\nv 1 1 5\nv 0 3 5\n" + face + "\n");
    ASSERT_EQ(mesh.triangles.size(), 2u);
    double area = 0.0;
    for (const glm::uvec3& t : mesh.triangles) {
      const glm::dvec3 n =
          glm::cross(mesh.positions[t.y] - mesh.positions[t.x], mesh.positions[t.z] - mesh.positions[t.x]);
      EXPECT_GE(n.z, 0.0) << "orientation, face from corner " << first;
      area += glm::length(n) / 2;
    }
    EXPECT_DOUBLE_EQ(area, 3.0) << "face from corner " << first;
  }
}

TEST_F(Obj, NormalsAreKeptWhenEveryCornerHasOne) {
  const MeshData mesh = load(kSquare + "vn 0 0 2\nvn 0 3 4\nf 1//1 2//1 3//1\nf 1/1/2 3/1/2 4/1/2\n");
  // Corners 1 and 3 have two normals each, so there are 6 vertices.
  EXPECT_EQ(mesh.positions.size(), 6u);
  ASSERT_EQ(mesh.normals.size(), 6u);
  EXPECT_EQ(mesh.normals[mesh.triangles[0].x], glm::dvec3(0, 0, 1));
  EXPECT_NEAR(glm::distance(mesh.normals[mesh.triangles[1].x], glm::dvec3(0, 0.6, 0.8)), 0.0, 1e-15);
  EXPECT_EQ(mesh.positions[mesh.triangles[1].z], glm::dvec3(0, 1, 0));
  EXPECT_THAT(warnings_, IsEmpty());
}

TEST_F(Obj, PartialOrZeroNormalsMeanFlatShadingAndAWarning) {
  for (const std::string faces :
       {"vn 0 0 1\nf 1//1 2//1 3//1\nf 1 3 4\n", "f 1 3 4\nvn 0 0 1\nf 1//1 2//1 3//1\n",
        "vn 0 0 1\nvn 0 0 0\nf 1//1 2//1 3//1\nf 1//2 3//2 4//2\n",
        "vn 0 0 1\nvn 0 0 1e200\nf 1//1 2//1 3//1\nf 1//2 3//2 4//2\n"}) {
    // The usable normals are the square's own, so nothing is smooth.
    EXPECT_TRUE(load(kSquare + faces).normals.empty());
    EXPECT_THAT(warnings_, ElementsAre("m.obj: 1 of 2 triangles without usable normals: shaded flat"));
  }
}

TEST_F(Obj, TrianglesWithoutUsableNormalsKeepTheirOwnAmongSmoothOnes) {
  const std::string smooth = kSquare + "vn 0 3 4\nf 1//1 2//1 3//1\n";
  for (const std::string flat :
       {"f 1 3 4\n", "vn nan nan nan\nf 1//2 3//1 4//1\n", "vn 1 1 0\nf 1//2 3//1 4//1\n"}) {
    const MeshData mesh = load(smooth + flat);
    ASSERT_EQ(mesh.normals.size(), 6u);
    EXPECT_NEAR(glm::distance(mesh.normals[mesh.triangles[0].z], glm::dvec3(0, 0.6, 0.8)), 0.0, 1e-15);
    for (int c = 0; c < 3; ++c) EXPECT_EQ(mesh.normals[mesh.triangles[1][c]], glm::dvec3(0, 0, 1)) << flat;
    EXPECT_EQ(warnings_.back(), "m.obj: 1 of 2 triangles without usable normals: shaded flat");
  }
}

TEST_F(Obj, NormalsThatAreNotFiniteAreCounted) {
  for (const std::string word :
       {"nan", "-nan", "NaN", "inf", "-inf", "nan(ind)", "-1.#IND", "1.#QNAN0", "1e400"}) {
    load(kTriangle + "vn 0 " + word + " 1\nf 1//1 2//1 3//1\n");
    EXPECT_THAT(warnings_, ElementsAre("m.obj: 1 normal that is not finite is not used (line 4)",
                                       "m.obj: 1 of 1 triangles without usable normals: shaded flat"))
        << word;
  }
}

TEST_F(Obj, StatementsMayGoOnInTheNextLine) {
  const MeshData mesh =
      load("v 0 0\\\n0\nv 1 \\ \n \\\r\n 0 0 # x\nv 0 1 0\n# C:\\models\\\nf 1\\\n 2 3 # y \\\nf 1 2 3 \\");
  EXPECT_EQ(mesh.positions.size(), 3u);
  EXPECT_EQ(mesh.positions.at(1), glm::dvec3(1, 0, 0));
  EXPECT_THAT(mesh.triangles, ElementsAre(glm::uvec3(0, 1, 2), glm::uvec3(0, 1, 2)));
  EXPECT_THAT(warnings_, IsEmpty());
  EXPECT_EQ(error_of("v 0 0 0\nv 1 \\\n 2 x\n"), "m.obj:3:4: 'x' is not a finite number");
  EXPECT_EQ(error_of(kTriangle + "f 1 2 \\\n9\n"),
            "m.obj:4: the face refers to vertex 9, but 3 are defined above it (is the file cut off or put "
            "together from "
            "parts?)");
}

TEST_F(Obj, CommentsMayFollowAnyStatement) {
  const MeshData mesh = load(
      "\xEF\xBB\xBFv 0 0 0# a\nv 1 0 0 # 7 8\nv 0 1 0\nvn 0 0 1 # n\ng a b # c\no # none\nusemtl m#1 # m\n"
      "s 1 # s\nl 1 2 # l\nf 1//1 2//1 3//1#f\n");
  EXPECT_THAT(mesh.triangles, ElementsAre(glm::uvec3(0, 1, 2)));
  EXPECT_EQ(mesh.parts.at(0).name, "m#1");
  EXPECT_THAT(warnings_, IsEmpty());
}

TEST_F(Obj, SlashesAtTheEndOfCornersAreCounted) {
  EXPECT_THAT(load(kSquare + "vt 0 0\nvn 0 0 1\nf 1/ 2// 3/1/\nf 1/1 3//1 4\n").triangles,
              ElementsAre(glm::uvec3(0, 1, 2), glm::uvec3(0, 2, 3)));
  EXPECT_EQ(warnings_.at(0),
            "m.obj: 3 corners with slashes at their ends are read without them (the first in line 7)");
}

TEST_F(Obj, FacesOfLessThanThreeCornersAreCounted) {
  EXPECT_EQ(load(kTriangle + "f 1 2\nf 3\nf\nf 1 2 3\n").triangles.size(), 1u);
  EXPECT_THAT(warnings_,
              ElementsAre("m.obj: 3 faces of less than three corners are left out (the first in line 4)"));
}

TEST_F(Obj, PolygonsMayHaveAnySizeAndRepeatedCorners) {
  std::string text, face = "f";
  for (int i = 0; i < 100000; ++i) {
    const double angle_rad = 6.283185307179586 * i / 100000;
    text += fmt::format("v {:.9f} {:.9f} 0\n", std::cos(angle_rad), std::sin(angle_rad));
    face += fmt::format(" {}", i + 1);
  }
  EXPECT_EQ(load(text + face + "\n").triangles.size(), 99998u);
  load(kSquare + "v 0 0 0\nf 1 2 3 4 5\nf 1 2 2 3 4 4\nf 1 3 2 4\n");
  EXPECT_THAT(
      warnings_,
      ElementsAre("m.obj: 3 corners are left out, being where their neighbours are (the first in line 6)",
                  "m.obj: 1 face crosses itself, so its triangles are a guess (line 8)"));
}

TEST_F(Obj, CapitalsAndTabsAndMaterialsWithoutALibrary) {
  EXPECT_EQ(load("usemtl a\nv\t0 0\t0\nv 1 0 0\n\tv 0 1 0\nf\t-3 -2\t-1\n", "MODEL.OBJ").triangles.size(),
            1u);
  EXPECT_EQ(load(compress(kTriangle + "f 1 2 3\n"), "M.Obj.ZST").triangles.size(), 1u);
  EXPECT_THAT(warnings_, IsEmpty());
}

TEST_F(Obj, PartsAreMaterialsInOrderOfAppearance) {
  const MeshData mesh =
      load(kSquare + "f 1 2 3\nusemtl wood \nf 1 3 4\nusemtl iron\nf 2 3 4\nusemtl wood\nf 1 2 4\n");
  ASSERT_EQ(mesh.parts.size(), 3u);
  EXPECT_EQ(mesh.parts[0].name, "");
  EXPECT_EQ(mesh.parts[1].name, "wood");
  EXPECT_EQ(mesh.parts[1].first_triangle, 1u);
  EXPECT_EQ(mesh.parts[1].triangle_count, 2u);
  EXPECT_EQ(mesh.parts[2].name, "iron");
  EXPECT_THAT(mesh.triangles, ElementsAre(glm::uvec3(0, 1, 2), glm::uvec3(0, 2, 3), glm::uvec3(0, 1, 3),
                                          glm::uvec3(1, 2, 3)));
}

TEST_F(Obj, FiltersChooseByMaterialGroupOrObject) {
  const std::string text =
      kSquare +
      "o chair\ng leg\nusemtl wood\nf 1 2 3\ng seat\nf 1 3 4\nusemtl glass\nf 2 3 4\no table\nf 1 2 4\n";
  filter_ = {.include = {"wood"}, .exclude = {}};
  EXPECT_EQ(load(text).triangles.size(), 2u);
  filter_ = {.include = {}, .exclude = {"seat"}};
  EXPECT_EQ(load(text).triangles.size(), 1u);
  filter_ = {.include = {"chair"}, .exclude = {"glass"}};
  EXPECT_EQ(load(text).triangles.size(), 2u);
  filter_ = {.include = {"leg", "table"}, .exclude = {}};
  EXPECT_EQ(load(text).triangles.size(), 2u);
}

TEST_F(Obj, FilterNamesMustOccur) {
  filter_ = {.include = {}, .exclude = {"glas"}};
  EXPECT_EQ(error_of(kTriangle + "usemtl glass\nf 1 2 3\n"),
            "m.obj: no material, group or object is called 'glas' (did you mean 'glass'?)");
  filter_ = {.include = {}, .exclude = {"glass"}};
  EXPECT_EQ(error_of(kTriangle + "usemtl glass\nf 1 2 3\n"),
            "m.obj: no face is left after 'include' and 'exclude'");
}

TEST_F(Obj, NumbersThatAreNotFiniteAreErrors) {
  EXPECT_EQ(error_of("v 0 0 0\nv 1 nan 0\n"), "m.obj:2:5: 'nan' is not a finite number");
  EXPECT_EQ(error_of("v inf 0 0\n"), "m.obj:1:3: 'inf' is not a finite number");
  EXPECT_EQ(error_of("v 0 0 1e400\n"), "m.obj:1: the vertex is not finite");
  EXPECT_EQ(error_of("vn 0 0 x\n"), "m.obj:1:8: 'x' is not a number");
  for (const std::string word : {"0x10", "1e", "1,5", "--1", ".", "1e+", "abc", "1.2.3"}) {
    EXPECT_EQ(error_of("v 0 0 " + word + "\n"), "m.obj:1:7: '" + word + "' is not a finite number");
  }
}

TEST_F(Obj, IndicesOutOfRangeAreErrors) {
  const std::string hint = " (is the file cut off or put together from parts?)";
  EXPECT_EQ(error_of(kTriangle + "f 1 2 4\n"),
            "m.obj:4: the face refers to vertex 4, but 3 are defined above it" + hint);
  EXPECT_EQ(error_of(kTriangle + "f 1 2 -4\n"),
            "m.obj:4: the face refers to vertex -4, but 3 are defined above it" + hint);
  EXPECT_EQ(error_of(kTriangle + "vn 0 0 1\nf 1//1 2//1 3//2\n"),
            "m.obj:5: the face refers to normal 2, but 1 are defined above it" + hint);
  for (const std::string corner :
       {"0", "1///", "1/2/3/", "//", "1/2/3/4", "a", "1.5", "99999999999", "1/0", "1//0", "/1"}) {
    EXPECT_EQ(
        error_of(kTriangle + "f 1 2 " + corner + "\n"),
        "m.obj:4:7: '" + corner + "' is not a corner of a face (i, i/j, i//k or i/j/k, counted from 1)");
  }
}

TEST_F(Obj, TruncatedLinesAreErrors) {
  EXPECT_EQ(error_of("v 0 0 0\nv 1 0"), "m.obj:2:6: 'v' needs three numbers, not 2 (is the file cut off?)");
  EXPECT_EQ(error_of(kTriangle + "f 1 2"),
            "m.obj:4:6: a face needs three corners, not 2 (is the file cut off?)");
  EXPECT_EQ(error_of("v"), "m.obj:1:2: 'v' needs three numbers, not 0 (is the file cut off?)");
}

TEST_F(Obj, BrokenCompressionIsAnError) {
  std::string text = kTriangle;
  for (int i = 0; i < 50000; ++i) text += fmt::format("v {} {} 0\n", i * 37 % 7919, i * 31 % 6007);
  const std::string packed = compress(text + "f 1 2 3\n");
  EXPECT_EQ(error_of(packed.substr(0, packed.size() / 2), "m.obj.zst"),
            "m.obj.zst: the zstd data ends early: the file is truncated");
  EXPECT_EQ(error_of("", "m.obj.zst"), "m.obj.zst: the zstd data ends early: the file is truncated");
  EXPECT_THAT(error_of("v 0 0 0\nplain text\n", "m.obj.zst"),
              HasSubstr("m.obj.zst: the zstd data is broken: "));
}

TEST_F(Obj, FilesThatAreNotPolygonMeshesAreErrors) {
  EXPECT_THAT(error_of("solid ascii\n"), HasSubstr("m.obj:1:1: unknown OBJ statement 'solid'"));
  EXPECT_THAT(error_of("curv 0 1 1 2 3\n"), EndsWith("(only polygons are read: v, vn, f, usemtl, g, o)"));
  EXPECT_EQ(error_of(std::string("v 0 0 0\n\0\0", 10)),
            "m.obj:2:1: a zero byte: this is not an OBJ text file (UTF-16 and binary files are not read)");
  EXPECT_EQ(error_of(std::string((size_t{65} << 20), 'x')),
            "m.obj:1: a line of over 64 MiB (this is not an OBJ text file)");
}

TEST_F(Obj, EmptyMeshesAreErrors) {
  EXPECT_EQ(error_of(""), "m.obj: the mesh has no faces");
  EXPECT_EQ(error_of(kTriangle), "m.obj: the mesh has no faces");
}

TEST_F(Obj, StatementsWithoutBearingOnShadowsAreIgnored) {
  const std::string text = "mtllib a.mtl\n" + kTriangle + "vt 0 0\ns off\nl 1 2\np 1\ng\nf 1/1 2/1 3/1\n";
  EXPECT_EQ(load(text).triangles.size(), 1u);
}

TEST_F(Obj, SceneLooksBesideItselfBeforeTheAssets) {
  const std::filesystem::path beside = folder_.path() / "scenes";
  const std::filesystem::path assets = folder_.path() / "assets";
  std::filesystem::create_directories(beside);
  std::filesystem::create_directories(assets);
  write_file_atomically(beside / "a.obj", kTriangle + "f 1 2 3\n");
  write_file_atomically(assets / "a.obj", kSquare + "f 1 2 3 4\n");
  write_file_atomically(assets / "b.obj", kSquare + "f 1 2 3 4\n");
  const auto triangles = [&](const std::string& file) {
    const SceneText text{.mesh = "file = \"" + file + "\""};
    return text.parse(beside / "x.toml", {.assets = assets, .library = {}}).triangles.size();
  };
  EXPECT_EQ(triangles("a.obj"), 1u);
  EXPECT_EQ(triangles("b.obj"), 2u);
}

}  // namespace
}  // namespace umbrameter
