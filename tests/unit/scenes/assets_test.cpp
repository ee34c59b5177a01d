// SPDX-License-Identifier: Apache-2.0
// Without these: the real models could stop loading, or lose triangles, unnoticed.
#include "core/files.h"
#include "scene_text.h"
#include "tests/support/models.h"

#include <gmock/gmock.h>

namespace umbrameter {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

class Assets : public testing::Test {
 protected:
  void SetUp() override {
    if (!has_models()) GTEST_SKIP() << no_models();
  }
  Scene load(const std::string& file) const {
    return SceneText{.mesh = "file = \"" + file + "\""}.parse("x.toml", search_);
  }
  SceneSearch search_ = model_search();
};

// Counts from the models' own description: triangles, and those dropped as repeated, zero or duplicate.

TEST_F(Assets, CrytekSponzaLoses1And70Of279163Triangles) {
  const Scene scene = load("crytek_sponza.obj.zst");
  EXPECT_EQ(scene.triangles.size(), 279163u - 71u);
  EXPECT_EQ(scene.parts.size(), 26u);
  EXPECT_THAT(scene.warnings,
              ElementsAre("crytek_sponza.obj.zst: dropped 1 triangle of zero area, 70 duplicates"));
}

TEST_F(Assets, DragonLosesItsDoubledTriangles) {
  const Scene scene = load("stanford_dragon_202k.obj.zst");
  EXPECT_EQ(scene.triangles.size(), 202520u - 1489u);
  EXPECT_NEAR(scene.bounds_world.min.x, -0.108188, 1e-8);
  EXPECT_NEAR(scene.bounds_world.max.y, 0.197139, 1e-8);
}

TEST_F(Assets, HairIsCleanAndWhole) {
  const Scene scene = load("hair_straight.obj.zst");
  EXPECT_EQ(scene.triangles.size(), 920000u);
  EXPECT_EQ(scene.positions_world.size(), 480000u);
  EXPECT_THAT(scene.warnings, IsEmpty());
}

TEST_F(Assets, SuzanneKeepsItsNormals) {
  const Scene scene = load("suzanne.obj");
  EXPECT_EQ(scene.normals_world.size(), scene.positions_world.size());
}

TEST_F(Assets, EverySmallAssetSceneLoads) {
  for (const SceneEntry& entry : list_scenes(search_)) {
    if (!entry.needs_assets) continue;
    EXPECT_THAT(entry.missing_assets, IsEmpty()) << entry.name;
    const bool large = entry.name == "assets/san_miguel" || entry.name == "assets/country_kitchen";
    if (large || !entry.missing_assets.empty()) continue;
    EXPECT_GT(load_scene(entry.file, search_).triangles.size(), 1000u) << entry.name;
  }
}

}  // namespace
}  // namespace umbrameter
