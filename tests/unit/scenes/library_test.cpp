// SPDX-License-Identifier: Apache-2.0
// Without these: a built-in scene could be broken, or its documented geometry could differ from its file.
#include "scene_text.h"
#include "tests/support/temporary_folder.h"

#include "core/files.h"
#include "tests/support/source_dir.h"

#include <gmock/gmock.h>

#include <glm/geometric.hpp>

#include <set>

namespace umbrameter {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::IsEmpty;

const std::filesystem::path kLibrary = source_dir() / "scenes/library";
const SceneSearch kSearch{.assets = {}, .library = kLibrary};

Scene load(const std::string& name) {
  return load_scene(resolve_scene(name, kSearch), kSearch);
}

TEST(SceneLibrary, EveryBuiltInSceneLoadsWithoutWarnings) {
  std::set<LightType> types;
  size_t count = 0;
  for (const SceneEntry& entry : list_scenes(kSearch)) {
    if (entry.needs_assets) continue;
    const Scene scene = load(entry.name);
    EXPECT_THAT(scene.warnings, IsEmpty()) << entry.name;
    EXPECT_NE(scene.title, entry.name) << "no title: " << entry.name;
    EXPECT_FALSE(scene.doc.empty()) << entry.name;
    for (const Light& light : scene.lights) types.insert(light.type);
    ++count;
  }
  EXPECT_EQ(count, 18u);
  EXPECT_EQ(types.size(), 4u) << "each light type occurs";
}

TEST(SceneLibrary, EveryCameraSeesTheScene) {
  for (const SceneEntry& entry : list_scenes(kSearch)) {
    if (entry.needs_assets) continue;
    const Scene scene = load(entry.name);
    const glm::dvec3 to_target = scene.camera.at_world - scene.camera.eye_world;
    EXPECT_LT(scene.camera.near_world, 0.1 * glm::length(to_target)) << entry.name;
  }
}

TEST(SceneLibrary, HalfPlaneHasItsRoundNumbers) {
  const Scene scene = load("half_plane");
  const Light& light = scene.light();
  EXPECT_EQ(light.center_world, glm::dvec3(0, 4, 0));
  EXPECT_EQ(light.size_world, glm::dvec2(1, 1));
  ASSERT_EQ(scene.triangles.size(), 4u);
  for (uint32_t t = 2; t < 4; ++t) {  // the sheet: y = 2, x <= 0
    for (int corner = 0; corner < 3; ++corner) {
      const glm::vec3 p = scene.positions_world[scene.triangles[t][corner]];
      EXPECT_EQ(p.y, 2.0f);
      EXPECT_TRUE(p.x == 0.0f || p.x == -20.0f) << p.x;
    }
  }
}

TEST(SceneLibrary, SlantedPlaneMakesSixtyDegreesWithItsSun) {
  const Scene scene = load("slanted_plane");
  EXPECT_NEAR(glm::dot(triangle_normal_world(scene, 0), -scene.light().direction_world), 0.5, 1e-6);
  EXPECT_GT(triangle_normal_world(scene, 0).x, 0.0) << "slopes down towards +x";
}

TEST(SceneLibrary, DiskOccluderHasTheStatedArea) {
  const Scene scene = load("disk_occluder");
  double area = 0.0;
  for (const glm::uvec3& t : scene.triangles) {
    const glm::dvec3 a = scene.positions_world[t.x];
    if (a.y != 2.0) continue;
    area += glm::length(glm::cross(glm::dvec3(scene.positions_world[t.y]) - a,
                                   glm::dvec3(scene.positions_world[t.z]) - a)) /
            2;
  }
  // The polygon's area is 1 - (2 pi / 1024)^2 / 6 = 1 - 6.3e-6 of the disk's, 0.25 pi.
  EXPECT_NEAR(area / (0.25 * 3.141592653589793), 1.0 - 6.3e-6, 2e-7);
}

TEST(SceneLibrary, ListsBuiltInScenesFirstThenAssetsByName) {
  TemporaryFolder folder;
  const std::string mesh = "[[mesh]]\nfile = \"gone.obj\"\n";
  create_folder(folder.path() / "assets");
  write_file_atomically(folder.path() / "b.toml", "title = \"B\"\n");
  write_file_atomically(folder.path() / "a.toml", "[[mesh]]\nshape = \"box\"\n");
  write_file_atomically(folder.path() / "assets/c.toml", mesh);
  const SceneSearch search{.assets = folder.path() / "models", .library = folder.path()};
  const std::vector<SceneEntry> entries = list_scenes(search);
  ASSERT_EQ(entries.size(), 3u);
  EXPECT_EQ(entries[0].name, "a");
  EXPECT_FALSE(entries[0].needs_assets);
  EXPECT_EQ(entries[1].name, "b");
  EXPECT_EQ(entries[1].title, "B");
  EXPECT_EQ(entries[2].name, "assets/c");
  EXPECT_TRUE(entries[2].needs_assets);
  EXPECT_THAT(entries[2].missing_assets, ElementsAre("gone.obj"));
  create_folder(search.assets);
  write_file_atomically(search.assets / "gone.obj", "v 0 0 0\n");
  EXPECT_TRUE(list_scenes(search)[2].needs_assets);
  EXPECT_THAT(list_scenes(search)[2].missing_assets, IsEmpty());
}

TEST(SceneLibrary, NamesAndPathsResolve) {
  EXPECT_EQ(resolve_scene("plate", kSearch), kLibrary / "plate.toml");
  const std::filesystem::path path = kLibrary / "wire.toml";
  EXPECT_EQ(resolve_scene(path.string(), kSearch), path);
}

TEST(SceneLibrary, UnknownNameGetsTheNearest) {
  EXPECT_EQ(message_of([] { resolve_scene("plaet", kSearch); }),
            "no scene or scene file is called 'plaet' (did you mean 'plate'?)");
}

}  // namespace
}  // namespace umbrameter
