// SPDX-License-Identifier: Apache-2.0
// Without these a leaf could be cut out of the wrong texels, or be a solid card without a word.
#include "scenes/cutouts.h"

#include "core/files.h"
#include "core/image_io.h"
#include "scene_text.h"
#include "scenes/read_mask.h"
#include "tests/support/cutout_card.h"
#include "tests/support/temporary_folder.h"

#include <gmock/gmock.h>

namespace umbrameter {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

const std::string kCorners = "v 0 1 0\nv 1 1 0\nv 1 1 1\nv 0 1 1\nvt 0 0\nvt 2 0\nvt 2 3\nvt 0 3\n";
const std::string kLeaf = "usemtl leaf\nf 1/1 2/2 3/3 4/4\n";

TEST(CutoutMask, TexelsAreFoundFromBelowAndRepeat) {
  const AlphaMask mask = pattern_mask({"#..", "..#"});  // v = 0 is the lower row
  EXPECT_TRUE(is_hole(mask, {0.1f, 0.1f}));
  EXPECT_FALSE(is_hole(mask, {0.9f, 0.1f}));
  EXPECT_FALSE(is_hole(mask, {0.1f, 0.9f}));
  EXPECT_FALSE(is_hole(mask, {-0.1f, 5.49f})) << "the right one of the lower row";
  EXPECT_FALSE(is_hole(mask, {7.0f, -0.5f})) << "texels begin at their left and lower edges";
  EXPECT_TRUE(is_hole(mask, {0.34f, -0.5f}));
  EXPECT_FALSE(is_hole(mask, {-1e-9f, 0.25f})) << "rounds up to the end, which is the last texel";
}

class Cutouts : public testing::Test {
 protected:
  void write(const std::string& name, const std::string& text) const {
    write_file_atomically(folder_.path() / name, text);
  }
  /// 2 x 2 texels by their first channel, or by their alpha.
  void write_picture(const std::string& name, const std::vector<float>& values,
                     const std::string& channel = "R") const {
    Image image(2, 2);
    image.add_plane("R", 1.0f);
    std::copy(values.begin(), values.end(), image.add_plane(channel).begin());
    write_exr(folder_.path() / name, image);
  }
  Scene load(const std::string& obj, const std::string& more = "") {
    write("leaf.obj", obj);
    const SceneText text{.mesh = "file = \"leaf.obj\"\n" + more};
    return text.parse(folder_.path() / "x.toml");
  }

  TemporaryFolder folder_;
};

TEST_F(Cutouts, MasksAreSolidFromHalfOnWithTheLowestRowFirst) {
  write_picture("mask.exr", {0.5f, 0.49f, 0.0f, 1.0f});  // upper row, lower row
  const AlphaMask mask = read_mask(folder_.path() / "mask.exr", 1.0f);
  EXPECT_THAT(mask.bits, ElementsAre(0b0110u));
  EXPECT_THAT(read_mask(folder_.path() / "mask.exr", 0.9f).bits, ElementsAre(0b0010u));
  write_picture("alpha.exr", {0.0f, 1.0f, 1.0f, 1.0f}, "A");
  EXPECT_THAT(read_mask(folder_.path() / "alpha.exr", 1.0f).bits, ElementsAre(0b1011u));
}

TEST_F(Cutouts, MaterialsWithAMaskAreCutOutLastAndCounted) {
  write("leaf.mtl", "newmtl leaf\nmap_d mask.exr\nnewmtl wood\n");
  write_picture("mask.exr", {1.0f, 0.0f, 0.0f, 1.0f});
  const Scene scene = load("mtllib leaf.mtl\n" + kCorners + kLeaf + "usemtl wood\nv 0 2 0\nf 1 2 5\n");
  EXPECT_THAT(scene.warnings, IsEmpty());
  ASSERT_EQ(scene.triangles.size(), 3u);
  ASSERT_EQ(scene.cutouts.size(), 2u);
  EXPECT_EQ(scene.first_cutout(), 1u);
  EXPECT_EQ(scene.cutouts[0].uv, (std::array{glm::vec2(0, 0), glm::vec2(2, 0), glm::vec2(2, 3)}));
  EXPECT_EQ(scene.cutouts[1].uv, (std::array{glm::vec2(0, 0), glm::vec2(2, 3), glm::vec2(0, 3)}));
  ASSERT_EQ(scene.parts.size(), 2u);
  EXPECT_EQ(scene.parts[0].name, "leaf/wood");
  EXPECT_EQ(scene.parts[1].name, "leaf/leaf");
  EXPECT_EQ(scene.parts[1].first_triangle, 1u);
  ASSERT_EQ(scene.masks.size(), 1u);
  EXPECT_THAT(scene.masks[0].bits, ElementsAre(0b0110u));
}

TEST_F(Cutouts, AMirroredMeshKeepsItsTexels) {
  write("leaf.mtl", "newmtl leaf\nmap_d mask.exr\n");
  write_picture("mask.exr", {1.0f, 0.0f, 0.0f, 1.0f});
  const Scene scene = load("mtllib leaf.mtl\n" + kCorners + kLeaf, "scale = [-1, 1, 1]");
  for (size_t t = 0; t < 2; ++t) {
    for (int c = 0; c < 3; ++c) {
      const glm::vec3 p = scene.positions_world[scene.triangles[t][c]];
      EXPECT_EQ(scene.cutouts[t].uv[static_cast<size_t>(c)], glm::vec2(-2.0f * p.x, 3.0f * p.z));
    }
  }
}

TEST_F(Cutouts, TheHashKnowsTheMaskAndWhereItLies) {
  write("leaf.mtl", "newmtl leaf\nmap_d mask.exr\n");
  const std::string obj = "mtllib leaf.mtl\n" + kCorners + kLeaf;
  write_picture("mask.exr", {1.0f, 0.0f, 0.0f, 1.0f});
  const std::string hash = load(obj).hash;
  write_picture("mask.exr", {1.0f, 0.0f, 1.0f, 1.0f});
  EXPECT_NE(load(obj).hash, hash);
  write_picture("mask.exr", {0.9f, 0.1f, 0.1f, 0.9f});
  EXPECT_EQ(load(obj).hash, hash) << "the same texels";
  write("leaf.mtl", "newmtl leaf\nmap_d -s 2 1 1 mask.exr\n");
  EXPECT_NE(load(obj).hash, hash);
  EXPECT_NE(load(kCorners + kLeaf).hash, hash);
}

TEST_F(Cutouts, WhatCannotBeCutOutIsSaid) {
  const std::string obj = "mtllib leaf.mtl\n" + kCorners + kLeaf;
  const Scene no_library = load(obj);
  EXPECT_THAT(
      no_library.warnings,
      ElementsAre("leaf.obj: the material library 'leaf.mtl' is not there, so no material has holes"));
  EXPECT_EQ(no_library.side_files.size(), 1u);
  write("leaf.mtl", "newmtl leaf\nmap_d gone.png\n");
  const Scene no_mask = load(obj);
  EXPECT_THAT(no_mask.warnings,
              ElementsAre("leaf.obj: 2 triangles of material 'leaf': the mask 'gone.png' is not there, "
                          "so they are solid"));
  EXPECT_TRUE(no_mask.cutouts.empty());
  EXPECT_EQ(no_mask.side_files.size(), 2u);
  EXPECT_EQ(no_mask.hash, load(kCorners + kLeaf).hash);
  write("leaf.mtl", "newmtl leaf\nd 0.1\n");
  const Scene glass = load(obj);
  EXPECT_THAT(
      glass.warnings,
      ElementsAre("leaf.obj: 2 triangles of material 'leaf' (d = 0.1), less than half there: a hole"));
  EXPECT_EQ(glass.cutouts.size(), 2u);
  write("leaf.mtl", "newmtl leaf\nd 0.9\n");
  EXPECT_TRUE(load(obj).cutouts.empty());
  EXPECT_THAT(load(kCorners + kLeaf + "mtllib leaf.mtl\n").warnings, IsEmpty());
}

TEST_F(Cutouts, TexturePointsThatAreOddAreSaid) {
  write("leaf.mtl", "newmtl leaf\nmap_d mask.exr\n");
  write_picture("mask.exr", {1.0f, 0.0f, 0.0f, 1.0f});
  const std::string head =
      "mtllib leaf.mtl\nv 0 1 0\nv 1 1 0\nv 1 1 1\nvt 0 nan\nvt 1 0\nvt 1e9 1\nusemtl leaf\n";
  EXPECT_THAT(load(head + "f 1/1 2/2 3/2\n").warnings,
              ElementsAre("leaf.obj: 1 texture point that is no number is taken as 0 0 (line 5)"));
  EXPECT_EQ(load(head + "f 1/1 2/2 3/3\n").warnings.back(),
            "leaf.obj: 1 triangle with holes: texture coordinates not finite or beyond 4096; solid");
  EXPECT_THAT(message_of([&] { load(head + "f 1/1 2/2 3/4\n"); }),
              testing::HasSubstr("the face refers to texture point 4, but 3 are defined above it"));
}

}  // namespace
}  // namespace umbrameter
