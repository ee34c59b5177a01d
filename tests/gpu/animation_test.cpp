// SPDX-License-Identifier: Apache-2.0
// Without these the two renderers could show two moments of one animation.
#include "core/files.h"
#include "core/progress.h"
#include "metrics/image/parity.h"
#include "reference/reference.h"
#include "scenes/load_scene.h"
#include "technique_fixture.h"
#include "tests/support/glb_file.h"
#include "tests/support/temporary_folder.h"

#include <gtest/gtest.h>

namespace umbrameter::test {
namespace {

constexpr int kWidth_px = 96, kHeight_px = 64;

/// A sheet that two joints bend over a floor, under a square that slides.
GlbFile figure() {
  GlbFile file;
  file.add_square_mesh();
  file.json["meshes"].push_back(file.json["meshes"][0]);
  nlohmann::json& attributes = file.json["meshes"][1]["primitives"][0]["attributes"];
  attributes["JOINTS_0"] =
      file.add(std::vector<uint8_t>{0, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0}, "VEC4");
  attributes["WEIGHTS_0"] =
      file.add(std::vector<float>{1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0}, "VEC4");
  file.json["skins"] = nlohmann::json::parse(R"([{"joints": [4, 5]}])");
  file.json["nodes"] = nlohmann::json::parse(R"([
      {"children": [1, 2, 3, 4, 5], "rotation": [-0.7071067811865476, 0, 0, 0.7071067811865476], "translation": [-2, 0, 2]},
      {"mesh": 0, "scale": [4, 4, 1]}, {"mesh": 0, "translation": [0, 3, 1]}, {"mesh": 1, "skin": 0},
      {"translation": [1, 1, 0.5]}, {"translation": [1, 1, 0.5]}])");
  file.animate(2, "translation", {0, 1}, {0, 3, 1, 3, 3, 1}, "VEC3");
  file.animate(5, "translation", {0, 1}, {1, 1, 0.5, 2, 1, 1.5}, "VEC3");
  return file;
}

TEST(animation, is_the_same_surfaces_in_both_renderers_at_every_moment) {
  UMBRAMETER_REQUIRE_GL();
  const TemporaryFolder folder;
  write_file_atomically(folder.path() / "x.glb", figure().glb());
  std::vector<std::string> hashes;
  for (const double time_s : {0.0, 0.4, 1.0}) {
    SceneSearch search;
    search.at = AnimationTime{time_s};
    const Scene scene = load_scene(folder.path() / "x.glb", search);
    for (const std::string& other : hashes) EXPECT_NE(scene.hash, other);
    hashes.push_back(scene.hash);
    const Frame drawn = render(scene, "hard", {}, 1, kWidth_px, kHeight_px);
    SilentProgress progress;
    ReferenceSettings settings;
    settings.samples_per_pixel = 8;
    const Frame traced =
        make_reference_renderer(settings)->render(scene, {kWidth_px, kHeight_px, 1, {}, {}}, progress);
    const glm::dvec3& eye_world = scene.camera.eye_world;
    const Parity parity = compare_surfaces(drawn.image, traced.image, eye_world, {});
    EXPECT_GE(parity.agreement, 0.995) << time_s;
    EXPECT_EQ(parity.same_primitive, parity.covered) << time_s;
    EXPECT_GT(parity.covered, 500u);
  }
}

}  // namespace
}  // namespace umbrameter::test
