// SPDX-License-Identifier: Apache-2.0
// Without these a scene at a moment could stand where it never does, or a bad key could end the program.
#include "core/files.h"
#include "scene_text.h"
#include "scenes/gltf/gltf_mesh.h"
#include "scenes/instances.h"
#include "tests/support/glb_file.h"
#include "tests/support/temporary_folder.h"

#include <gmock/gmock.h>

#include <glm/geometric.hpp>

#include <cmath>
#include <limits>
#include <numbers>

namespace umbrameter {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

/// A square on a node under a parent.
GlbFile square_under_parent() {
  GlbFile file;
  file.add_square_mesh();
  file.json["nodes"] =
      nlohmann::json::parse(R"([{"name": "parent", "children": [1]}, {"name": "own", "mesh": 0}])");
  return file;
}

class GltfAnimation : public testing::Test {
 protected:
  MeshData load(const GlbFile& file, double time_s, const std::string& animation = "") {
    warnings_.clear();
    write_file_atomically(path(), file.glb());
    return load_gltf_mesh(open_gltf(path(), AnimationTime{time_s, animation}), {}, warnings_);
  }
  /// Where the square's corner (1, 1, 0) is.
  glm::dvec3 corner(const GlbFile& file, double time_s, const std::string& animation = "") {
    return load(file, time_s, animation).positions.at(2);
  }
  std::string error_of(const GlbFile& file, const std::string& animation = "") {
    const std::string message = message_of([&] { load(file, 0.5, animation); });
    const std::string start = path().string() + ": ";
    EXPECT_EQ(message.substr(0, start.size()), start);
    return message.substr(std::min(start.size(), message.size()));
  }
  std::filesystem::path path() const { return folder_.path() / "x.glb"; }

  TemporaryFolder folder_;
  std::vector<std::string> warnings_;
};

void expect_at(const glm::dvec3& p, const glm::dvec3& wanted, const char* what) {
  EXPECT_NEAR(glm::distance(p, wanted), 0.0, 1e-6) << what << " at " << p.x << " " << p.y << " " << p.z;
}

TEST_F(GltfAnimation, LinearKeysMoveTurnAndScaleNodesInTheirParents) {
  GlbFile file = square_under_parent();
  const auto half = static_cast<float>(std::numbers::sqrt2 / 2);
  file.animate(0, "translation", {0, 2}, {0, 0, 0, 4, 0, 0}, "VEC3");
  file.animate(1, "rotation", {0, 1}, {0, 0, 0, 1, 0, 0, half, half}, "VEC4");  // a quarter turn about z
  file.animate(1, "scale", {0, 1}, {1, 1, 1, 3, 3, 3}, "VEC3");
  expect_at(corner(file, 0.0), {1, 1, 0}, "first keys");
  expect_at(corner(file, 0.5), {1, 2 * std::numbers::sqrt2, 0}, "an eighth of a turn, twice as large, 1 on");
  expect_at(corner(file, 1.0), {2 - 3, 3, 0}, "a quarter turn");
  expect_at(corner(file, 1.5), {3 - 3, 3, 0}, "one channel ends before the other");
  EXPECT_THAT(warnings_, IsEmpty());
}

TEST_F(GltfAnimation, RotationsTakeTheShorterWay) {
  GlbFile file = square_under_parent();
  const auto half = static_cast<float>(std::numbers::sqrt2 / 2);
  file.animate(1, "rotation", {0, 1}, {0, 0, 0, 1, 0, 0, -half, -half}, "VEC4");  // the same turn, other sign
  expect_at(corner(file, 0.5), {0, std::numbers::sqrt2, 0}, "an eighth of a turn");
}

TEST_F(GltfAnimation, StepsHoldAKeyUntilTheNext) {
  GlbFile file = square_under_parent();
  file.animate(1, "translation", {0, 1, 2}, {0, 0, 0, 5, 0, 0, 9, 0, 0}, "VEC3", "STEP");
  expect_at(corner(file, 0.999), {1, 1, 0}, "before");
  expect_at(corner(file, 1.0), {6, 1, 0}, "at");
  expect_at(corner(file, 1.999), {6, 1, 0}, "after");
}

TEST_F(GltfAnimation, CubicSplinesAreHermites) {
  GlbFile file = square_under_parent();
  // In-tangent, value, out-tangent of each key; a way of 2 s from 0 to 8, leaving with 1 a second, arriving with 3.
  file.animate(1, "translation", {1, 3}, {7, 7, 7, 0, 0, 0, 1, 0, 0, 3, 0, 0, 8, 0, 0, 7, 7, 7}, "VEC3",
               "CUBICSPLINE");
  const double u = 0.25, u2 = u * u, u3 = u2 * u;
  const double x = 2 * (u3 - 2 * u2 + u) * 1 + (3 * u2 - 2 * u3) * 8 + 2 * (u3 - u2) * 3;
  expect_at(corner(file, 1.5), {1 + x, 1, 0}, "a quarter of the way");
  expect_at(corner(file, 3.0), {9, 1, 0}, "the last key");
  GlbFile turned = square_under_parent();
  turned.animate(1, "rotation", {0, 1},
                 {0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0}, "VEC4",
                 "CUBICSPLINE");
  expect_at(corner(turned, 0.5), {-1, 1, 0}, "(0, 0, 1/2, 1/2) made unit is a quarter turn");
}

TEST_F(GltfAnimation, BeyondItsEndsTheNearestKeyHoldsAndThatIsSaid) {
  GlbFile file = square_under_parent();
  file.animate(1, "translation", {1, 2}, {3, 0, 0, 4, 0, 0}, "VEC3");
  expect_at(corner(file, 0.25), {4, 1, 0}, "before");
  EXPECT_THAT(warnings_,
              ElementsAre("x.glb: 0.25 s lies before the first key of animation 'move' at 1 s, which holds"));
  expect_at(corner(file, 7), {5, 1, 0}, "after");
  EXPECT_THAT(warnings_,
              ElementsAre("x.glb: 7 s lies beyond the last key of animation 'move' at 2 s, which holds"));
}

TEST_F(GltfAnimation, OneOfSeveralIsChosenByNameOrNumber) {
  GlbFile file = square_under_parent();
  file.animate(1, "translation", {0}, {1, 0, 0}, "VEC3", "LINEAR", 0, "walk");
  file.animate(1, "translation", {0}, {2, 0, 0}, "VEC3", "LINEAR", 1, "run");
  file.animate(0, "translation", {0}, {0, 5, 0}, "VEC3", "LINEAR", 2, "lift");
  expect_at(corner(file, 0), {2, 1, 0}, "the first");
  EXPECT_THAT(warnings_, ElementsAre("x.glb: it has 3 animations ('walk', 'run', 'lift'); 'walk' is shown"));
  expect_at(corner(file, 0, "run"), {3, 1, 0}, "by name");
  EXPECT_THAT(warnings_, IsEmpty());
  expect_at(corner(file, 0, "3"), {1, 6, 0}, "by number");
  EXPECT_EQ(load(file, 0, "3").animation, "lift");
  EXPECT_EQ(error_of(file, "rum"),
            "no animation is called 'rum' (there are 'walk', 'run', 'lift'; numbers go from 1 to 3, and "
            "'all' shows all "
            "of them at once)");
  EXPECT_EQ(error_of(file, "all"),
            "channel 0 of animation 'run' moves the translation of node 'own', which another channel moves "
            "already");
  file.json["animations"].erase(1);
  expect_at(corner(file, 0, "all"), {2, 6, 0}, "both");
  EXPECT_EQ(load(file, 0, "all").animation, "walk + lift");
}

TEST_F(GltfAnimation, WithoutATimeAnimationsAreCounted) {
  GlbFile file = square_under_parent();
  file.animate(1, "translation", {0}, {1, 0, 0}, "VEC3");
  write_file_atomically(path(), file.glb());
  EXPECT_EQ(load_gltf_mesh(open_gltf(path()), {}, warnings_).positions.at(2), glm::dvec3(1, 1, 0));
  EXPECT_THAT(warnings_,
              ElementsAre("x.glb: 1 animation is not shown ('move'): 'time' or --time chooses a moment"));
}

TEST_F(GltfAnimation, MorphTargetsAddTheirWeightsShare) {
  GlbFile file = square_under_parent();
  const int wide = file.add(std::vector<float>{0, 0, 0, 2, 0, 0, 2, 0, 0, 0, 0, 0}, "VEC3");
  const int tall = file.add(std::vector<float>{0, 0, 0, 0, 0, 0, 0, 4, 0, 0, 4, 0}, "VEC3");
  file.primitive()["targets"] = {{{"POSITION", wide}}, {{"POSITION", tall}}};
  expect_at(corner(file, 0), {1, 1, 0}, "no weights are zeros");
  file.json["meshes"][0]["weights"] = {0.5, 0};
  expect_at(corner(file, 0), {2, 1, 0}, "the mesh's own");
  file.json["nodes"][1]["weights"] = {0, 0.5};
  expect_at(corner(file, 0), {1, 3, 0}, "the node's count more");
  file.animate(1, "weights", {0, 1}, {0, 0, 1, 0.5}, "SCALAR");
  expect_at(corner(file, 0.5), {1 + 0.5 * 2, 1 + 0.25 * 4, 0}, "the animation's count most");
  file.animate(1, "weights", {0, 1}, {0, 0}, "SCALAR", "LINEAR", 1, "short");
  EXPECT_EQ(error_of(file, "short"), "channel 0 of animation 'short' has 2 values for 2 keys, not 4");
}

TEST_F(GltfAnimation, SparseTargetsAreFilledIn) {
  GlbFile file = square_under_parent();
  const int indices = file.add(std::vector<uint16_t>{2}, "SCALAR");
  const int values = file.add(std::vector<float>{0, 0, 6}, "VEC3");
  nlohmann::json& accessors = file.json["accessors"];
  const nlohmann::json sparse = {
      {"count", 1},
      {"indices", {{"bufferView", accessors[indices]["bufferView"]}, {"componentType", 5123}}},
      {"values", {{"bufferView", accessors[values]["bufferView"]}}}};
  accessors.push_back({{"componentType", 5126}, {"count", 4}, {"type", "VEC3"}, {"sparse", sparse}});
  file.primitive()["targets"] = {{{"POSITION", accessors.size() - 1}}};
  file.json["meshes"][0]["weights"] = {0.5};
  const MeshData mesh = load(file, 0);
  expect_at(mesh.positions.at(2), {1, 1, 3}, "its one vertex");
  expect_at(mesh.positions.at(1), {1, 0, 0}, "another one");
  accessors.back()["sparse"]["count"] = 5;
  EXPECT_THAT(error_of(file), HasSubstr("(morph target) replaces more than it has"));
  accessors.back()["sparse"]["count"] = 1;
  file.bytes[48 + 12] = 9;  // behind positions and indices: the sparse index
  EXPECT_THAT(error_of(file), HasSubstr("(morph target) replaces element 9, but has 4"));
  accessors.back()["count"] = 1000000000;
  EXPECT_THAT(error_of(file), HasSubstr("(morph target) wants 1000000000 elements"));
}

TEST_F(GltfAnimation, InstancesStayInstancesWhereNodesMove) {
  constexpr uint16_t kSide = 160;
  GlbFile file;
  std::vector<float> positions;
  std::vector<uint16_t> indices;
  for (uint16_t y = 0; y < kSide; ++y) {
    for (uint16_t x = 0; x < kSide; ++x) {
      positions.insert(positions.end(),
                       {static_cast<float>(x), static_cast<float>(y), static_cast<float>(x % 3)});
      if (x + 1 == kSide || y + 1 == kSide) continue;
      const auto at = static_cast<uint16_t>(y * kSide + x), above = static_cast<uint16_t>(at + kSide);
      for (const int corner : {at + 0, at + 1, above + 0, at + 1, above + 1, above + 0})
        indices.push_back(static_cast<uint16_t>(corner));
    }
  }
  const int position = file.add(positions, "VEC3"), index = file.add(indices, "SCALAR");
  file.json["meshes"].push_back(
      {{"primitives", {{{"attributes", {{"POSITION", position}}}, {"indices", index}}}}});
  file.json["nodes"] = nlohmann::json::parse(
      R"([{"children": [1, 2, 3, 4]}, {"mesh": 0}, {"mesh": 0, "translation": [500, 0, 0]},
          {"mesh": 0, "translation": [900, 0, 0]}, {"mesh": 0, "translation": [1300, 0, 0]}])");
  file.animate(2, "translation", {0, 1}, {500, 0, 0, 500, 0, 40}, "VEC3");
  write_file_atomically(path(), file.glb());
  const SceneText text{.mesh = "file = \"x.glb\"\ntime = 0.25"};
  const Scene scene = text.parse(folder_.path() / "x.toml");
  ASSERT_EQ(scene.instanced.size(), 1u);
  ASSERT_EQ(scene.instanced[0]->world_from_mesh.size(), 4u);
  EXPECT_EQ(scene.instanced[0]->world_from_mesh[1][3], glm::vec3(500, 0, 10));
  EXPECT_EQ(scene.triangles.size(), 0u);
  file.json["nodes"][3]["scale"] = {1, 1, 0};
  write_file_atomically(path(), file.glb());
  const Scene squashed = text.parse(folder_.path() / "x.toml");
  ASSERT_EQ(squashed.instanced.size(), 1u) << "one flat place does not unroll the others";
  EXPECT_EQ(squashed.instanced[0]->world_from_mesh.size(), 3u);
  EXPECT_EQ(squashed.triangles.size(), size_t{2} * (kSide - 1) * (kSide - 1)) << "it has a copy";
  EXPECT_EQ(squashed.positions_world[0].z, 0.0f);
}

TEST_F(GltfAnimation, ScenesSayTheTimeAndHaveAHashOfTheirOwn) {
  GlbFile file = square_under_parent();
  file.animate(1, "translation", {0, 1}, {0, 0, 0, 1, 0, 0}, "VEC3", "LINEAR", 0, "slide");
  write_file_atomically(path(), file.glb());
  const auto scene_at = [&](const std::string& keys, const SceneSearch& search = {}) {
    return parse_scene(SceneText{.mesh = "name = \"door\"\nfile = \"x.glb\"\n" + keys}.document(),
                       folder_.path() / "x.toml", search);
  };
  const Scene early = scene_at("time = 0.25"), late = scene_at("time = 1\nanimation = \"slide\"");
  EXPECT_NE(early.hash, late.hash);
  EXPECT_EQ(late.hash, scene_at("time = 9\nanimation = 1").hash) << "the last key holds";
  ASSERT_EQ(early.animated.size(), 1u);
  EXPECT_EQ(early.animated[0].mesh, "door");
  EXPECT_EQ(early.animated[0].file, "x.glb");
  EXPECT_EQ(early.animated[0].animation, "slide");
  EXPECT_EQ(early.animated[0].time_s, 0.25);
  EXPECT_EQ(scene_at("time = 1", {.assets = {}, .library = {}, .light = {}, .at = AnimationTime{0.25}}).hash,
            early.hash)
      << "the command line's time counts more";
  EXPECT_TRUE(scene_at("").animated.empty());
  EXPECT_THAT(message_of([&] { scene_at("animation = \"slide\""); }),
              HasSubstr("'animation' goes with 'time'"));
  EXPECT_THAT(message_of([&] { scene_at("time = nan"); }),
              HasSubstr("'time' is nan, which is not a finite number"));
  file.json.erase("animations");
  write_file_atomically(path(), file.glb());
  EXPECT_THAT(message_of([&] { scene_at("time = 1"); }),
              HasSubstr("'time' is given, but 'x.glb' has no animation"));
  EXPECT_THAT(
      message_of([&] { scene_at("", {.assets = {}, .library = {}, .light = {}, .at = AnimationTime{1.0}}); }),
      HasSubstr("x.toml: it cannot be shown at 1 s: it has no animation"));
  EXPECT_THAT(message_of([&] {
                load_scene(path(), {.assets = {}, .library = {}, .light = {}, .at = AnimationTime{1.0}});
              }),
              HasSubstr("x.glb: it cannot be shown at 1 s: it has no animation"));
}

TEST_F(GltfAnimation, ImportedCamerasAndLightsStandWhereTheyAreThen) {
  GlbFile file = square_under_parent();
  file.json["cameras"] =
      nlohmann::json::parse(R"([{"type": "perspective", "perspective": {"yfov": 0.5, "znear": 0.1}}])");
  file.json["extensions"] =
      nlohmann::json::parse(R"({"KHR_lights_punctual": {"lights": [{"type": "point"}]}})");
  file.json["nodes"].push_back(
      nlohmann::json::parse(R"({"name": "lamp", "extensions": {"KHR_lights_punctual": {"light": 0}}})"));
  file.json["nodes"].push_back(
      nlohmann::json::parse(R"({"name": "eye", "camera": 0, "translation": [0.5, 0.5, 4]})"));
  file.json["nodes"][0]["children"] = {1, 2, 3};
  file.animate(2, "translation", {0, 1}, {0, 2, 1, 4, 2, 1}, "VEC3");
  write_file_atomically(path(), file.glb());
  const auto at = [&](double time_s) {
    return load_scene(path(), {.assets = {}, .library = {}, .light = {}, .at = AnimationTime{time_s}});
  };
  EXPECT_EQ(at(0.5).light().center_world, glm::dvec3(2, 2, 1));
  EXPECT_NE(at(0.5).hash, at(0.75).hash) << "the light alone moves";
  EXPECT_EQ(at(0.5).animated.at(0).time_s, 0.5);
  const SceneText text{.mesh = "file = \"x.glb\""};
  const Scene other = parse_scene(text.document(), folder_.path() / "x.toml",
                                  {.assets = {}, .library = {}, .light = {}, .at = AnimationTime{0.5}});
  EXPECT_THAT(other.warnings,
              testing::Contains("x.glb: its animation also moves 1 of its cameras and lights; those of the "
                                "scene file stay"));
  file.animate(2, "scale", {0, 1}, {0, 0, 0, 0, 0, 0}, "VEC3");
  write_file_atomically(path(), file.glb());
  EXPECT_THAT(at(0.5).warnings,
              testing::Contains("x.glb: light 'lamp' is scaled to nothing and is left out"));
}

TEST_F(GltfAnimation, BadKeysAreSentences) {
  const auto problem = [&](const std::vector<float>& times_s, const std::vector<float>& values) {
    GlbFile file = square_under_parent();
    file.animate(1, "translation", times_s, values, "VEC3");
    return error_of(file);
  };
  EXPECT_EQ(problem({0, kNan}, {0, 0, 0, 1, 0, 0}),
            "channel 0 of animation 'move' has the time nan at key 1");
  EXPECT_EQ(problem({0, 2, 1}, {0, 0, 0, 1, 0, 0, 2, 0, 0}),
            "channel 0 of animation 'move' goes back in time at key 2: from 2 s to 1 s");
  EXPECT_EQ(problem({0, 1}, {0, 0, 0, kNan, 0, 0}),
            "channel 0 of animation 'move' has a key whose value is not finite");
  EXPECT_EQ(problem({0, 1}, {0, 0, 0}), "channel 0 of animation 'move' has 3 values for 2 keys, not 6");
  EXPECT_EQ(problem({}, {}), "channel 0 of animation 'move' has no keys");
}

TEST_F(GltfAnimation, BadChannelsAreSentences) {
  GlbFile file = square_under_parent();
  file.animate(1, "translation", {0}, {1, 0, 0}, "VEC3");
  const GlbFile fine = file;
  const auto animation = [&]() -> nlohmann::json& { return file.json["animations"][0]; };
  animation()["channels"][0]["sampler"] = 3;
  EXPECT_EQ(error_of(file), "channel 0 of animation 'move' names sampler 3, but there are 1");
  animation()["channels"][0].erase("sampler");
  EXPECT_EQ(error_of(file), "its animations cannot be read: a channel names no sampler");
  file = fine;
  animation()["samplers"][0].erase("input");
  EXPECT_THAT(error_of(file), HasSubstr("`input` field is missing in animation.sampler"));
  file = fine;
  animation()["samplers"][0]["input"] = 99;
  EXPECT_EQ(error_of(file), "accessor 99 (key times) does not exist");
  file = fine;
  animation()["samplers"][0]["interpolation"] = "BEZIER";
  EXPECT_EQ(error_of(file),
            "channel 0 of animation 'move' has the interpolation 'BEZIER', which is not known");
  file = fine;
  animation()["channels"][0]["target"]["node"] = 9;
  EXPECT_EQ(error_of(file), "channel 0 of animation 'move' moves node 9, but there are 2");
  file = fine;
  file.json["nodes"][1]["matrix"] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
  EXPECT_EQ(error_of(file), "channel 0 of animation 'move' moves node 'own', which has a matrix");
  file = fine;
  file.animate(1, "weights", {0}, {1}, "SCALAR");
  EXPECT_EQ(error_of(file),
            "channel 1 of animation 'move' moves weights of node 'own', which has no morph targets");
  file = fine;
  animation()["channels"][0]["target"].erase("node");
  load(file, 0);
  EXPECT_THAT(warnings_, testing::Contains("x.glb: 1 animation channel without a node is left out"));
  file = fine;
  animation()["channels"][0]["target"]["path"] = "pointer";
  load(file, 0);
  EXPECT_THAT(warnings_,
              testing::Contains(
                  "x.glb: of animation 'move' 1 channel is left out: no node's place or morph targets"));
  file = square_under_parent();
  file.animate(1, "rotation", {0}, {0, 0, 0, 0}, "VEC4");
  EXPECT_EQ(error_of(file), "channel 0 of animation 'move' holds a rotation of length 0");
}

}  // namespace
}  // namespace umbrameter
