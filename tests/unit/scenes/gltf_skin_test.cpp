// SPDX-License-Identifier: Apache-2.0
// Without these a skinned figure could stand in pieces, or joints that are not there could be read past the end.
#include "core/files.h"
#include "scene_text.h"
#include "scenes/gltf/gltf_mesh.h"
#include "tests/support/glb_file.h"
#include "tests/support/temporary_folder.h"

#include <gmock/gmock.h>

#include <glm/geometric.hpp>

#include <cmath>
#include <limits>
#include <numbers>

namespace umbrameter {
namespace {

using testing::HasSubstr;

/// The square; its left corners belong to a joint at the origin, the right ones half to that and half to one at (1, 0, 0), as its
/// inverse bind matrix knows. The mesh's own node stands far away.
struct Bent {
  GlbFile file;
  int joints = 0, weights = 0;

  Bent() {
    file.add_square_mesh();
    joints = file.add(std::vector<uint8_t>{0, 7, 7, 7, 0, 1, 7, 7, 0, 1, 7, 7, 0, 7, 7, 7}, "VEC4");
    weights = file.add(std::vector<float>{1, 0, 0, 0, 0.5, 0.5, 0, 0, 0.5, 0.5, 0, 0, 1, 0, 0, 0}, "VEC4");
    const int binds = file.add(std::vector<float>{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0,  0, 0, 1,
                                                  1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, -1, 0, 0, 1},
                               "MAT4");
    file.primitive()["attributes"]["JOINTS_0"] = joints;
    file.primitive()["attributes"]["WEIGHTS_0"] = weights;
    file.json["skins"] = {{{"joints", {2, 3}}, {"inverseBindMatrices", binds}}};
    file.json["nodes"] = nlohmann::json::parse(R"([{"name": "root", "children": [1, 2]},
        {"name": "figure", "mesh": 0, "skin": 0, "translation": [50, 0, 0]},
        {"name": "hip", "children": [3]}, {"name": "knee", "translation": [1, 0, 0]}])");
  }

  void set(int accessor, size_t number, float value) {
    const size_t view = file.json["accessors"][static_cast<size_t>(accessor)]["bufferView"];
    const size_t start = file.json["bufferViews"][view]["byteOffset"];
    std::memcpy(file.bytes.data() + start + number * sizeof value, &value, sizeof value);
  }
};

class GltfSkin : public testing::Test {
 protected:
  MeshData load(const GlbFile& file, const std::optional<AnimationTime>& at = {}) {
    warnings_.clear();
    write_file_atomically(path(), file.glb());
    return load_gltf_mesh(open_gltf(path(), at), {}, warnings_);
  }
  std::string error_of(const GlbFile& file) {
    const std::string message = message_of([&] { load(file); });
    const std::string start = path().string() + ": ";
    EXPECT_EQ(message.substr(0, start.size()), start);
    return message.substr(std::min(start.size(), message.size()));
  }
  std::filesystem::path path() const { return folder_.path() / "x.glb"; }

  TemporaryFolder folder_;
  std::vector<std::string> warnings_;
};

TEST_F(GltfSkin, VerticesFollowTheirJointsAndNotTheirNode) {
  Bent bent;
  const MeshData rest = load(bent.file);
  EXPECT_EQ(rest.positions.at(2), glm::dvec3(1, 1, 0)) << "as it was bound";
  const auto half = static_cast<float>(std::numbers::sqrt2 / 2);
  bent.file.animate(3, "rotation", {0, 1}, {0, 0, 0, 1, 0, 0, half, half}, "VEC4");
  bent.file.animate(2, "translation", {0, 1}, {0, 0, 0, 0, 0, 6}, "VEC3");
  const MeshData bound = load(bent.file, AnimationTime{1.0});
  EXPECT_NEAR(glm::distance(bound.positions.at(3), glm::dvec3(0, 1, 6)), 0.0, 1e-6) << "the hip's own";
  // (1, 1) is (0, 1) for the knee, which a quarter turn takes to (-1, 0), which is (0, 0) in the hip's space.
  EXPECT_NEAR(glm::distance(bound.positions.at(2), glm::dvec3(0.5, 0.5, 6)), 0.0, 1e-6) << "half each";
  const MeshData between = load(bent.file, AnimationTime{0.5});
  const double c = std::cos(std::numbers::pi / 4);
  EXPECT_NEAR(glm::distance(between.positions.at(2), glm::dvec3(0.5 * (1 + 1 - c), 0.5 * (1 + c), 3)), 0.0,
              1e-6);
}

TEST_F(GltfSkin, NormalsTurnAndMirroredJointsKeepTheOutsideOutside) {
  Bent bent;
  bent.file.primitive()["attributes"]["NORMAL"] =
      bent.file.add(std::vector<float>{0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1}, "VEC3");
  bent.file.json["nodes"][2]["rotation"] = {0, std::numbers::sqrt2 / 2, 0, std::numbers::sqrt2 / 2};
  MeshData mesh = load(bent.file);
  EXPECT_NEAR(glm::distance(mesh.normals.at(2), glm::dvec3(1, 0, 0)), 0.0, 1e-6);
  bent.file.json["nodes"][2].erase("rotation");
  bent.file.json["nodes"][2]["scale"] = {-1, 1, 1};
  mesh = load(bent.file);
  EXPECT_EQ(mesh.positions.at(1), glm::dvec3(-1, 0, 0));
  EXPECT_EQ(mesh.triangles.at(0), glm::uvec3(0, 2, 1)) << "so that it still faces +z";
  EXPECT_NEAR(glm::distance(mesh.normals.at(2), glm::dvec3(0, 0, 1)), 0.0, 1e-6);
}

TEST_F(GltfSkin, BytesThatRoundAreScaledToOne) {
  Bent bent;
  const int weights =
      bent.file.add(std::vector<uint8_t>{255, 0, 0, 0, 127, 127, 0, 0, 127, 127, 0, 0, 255, 0, 0, 0}, "VEC4");
  bent.file.json["accessors"][static_cast<size_t>(weights)]["normalized"] = true;
  bent.file.primitive()["attributes"]["WEIGHTS_0"] = weights;
  EXPECT_NEAR(glm::distance(load(bent.file).positions.at(2), glm::dvec3(1, 1, 0)), 0.0, 1e-12);
}

TEST_F(GltfSkin, MorphTargetsComeBeforeJoints) {
  Bent bent;
  bent.file.primitive()["targets"] = {
      {{"POSITION", bent.file.add(std::vector<float>{0, 0, 0, 0, 0, 0, 0, 2, 0, 0, 2, 0}, "VEC3")}}};
  bent.file.json["meshes"][0]["weights"] = {0.5};
  bent.file.json["nodes"][2]["translation"] = {0, 0, 6};
  EXPECT_NEAR(glm::distance(load(bent.file).positions.at(3), glm::dvec3(0, 2, 6)), 0.0, 1e-12);
}

TEST_F(GltfSkin, WhatDoesNotHoldTogetherIsASentence) {
  const auto problem = [&](const auto& spoil) {
    Bent bent;
    spoil(bent);
    return error_of(bent.file);
  };
  const float nan = std::numeric_limits<float>::quiet_NaN();
  EXPECT_EQ(problem([](Bent& b) { b.set(b.weights, 5, 0.25f); }),
            "the weights of vertex 1 sum to 0.75, not to 1");
  EXPECT_EQ(problem([](Bent& b) { b.set(b.weights, 0, 0.0f); }),
            "the weights of vertex 0 sum to 0, not to 1");
  EXPECT_EQ(problem([](Bent& b) { b.set(b.weights, 5, -0.5f); }), "vertex 1 has the weight -0.5 of a joint");
  EXPECT_EQ(problem([&](Bent& b) { b.set(b.weights, 5, nan); }), "vertex 1 has the weight nan of a joint");
  EXPECT_EQ(problem([](Bent& b) { b.file.json["skins"][0]["joints"] = {2}; }),
            "vertex 1 has joint 1, but skin 0 has 1");
  EXPECT_EQ(problem([](Bent& b) { b.file.json["nodes"][1]["skin"] = 4; }),
            "skin 4 is named, but there are 1");
  EXPECT_EQ(problem([](Bent& b) {
              b.file.json["skins"][0]["joints"] = {2, 8};
            }),
            "skin 0 has node 8 as a joint, which is not in the scene");
  EXPECT_EQ(problem([](Bent& b) {
              b.file.json["skins"][0]["joints"] = {2, 3, 0};
            }),
            "skin 0 has 2 inverse bind matrices for 3 joints");
  EXPECT_EQ(problem([](Bent& b) { b.file.json["nodes"][3]["children"] = {2}; }),
            "node 'hip' is its own ancestor or has two parents")
      << "joints in a circle";
  EXPECT_EQ(problem([](Bent& b) { b.file.primitive()["attributes"].erase("WEIGHTS_0"); }),
            "a primitive with skin 0 has only one of JOINTS_0 and WEIGHTS_0");
  EXPECT_EQ(problem([](Bent& b) {
              b.file.primitive()["attributes"].erase("WEIGHTS_0");
              b.file.primitive()["attributes"].erase("JOINTS_0");
            }),
            "a primitive with skin 0 has no JOINTS_0 and WEIGHTS_0");
  EXPECT_THAT(problem([](Bent& b) { b.file.json["skins"][0]["inverseBindMatrices"] = 77; }),
              HasSubstr("accessor 77 (inverse bind matrices) does not exist"));
  EXPECT_THAT(problem([](Bent& b) { b.file.primitive()["attributes"]["JOINTS_0"] = 77; }),
              HasSubstr("accessor 77 (joints) does not exist"));
}

}  // namespace
}  // namespace umbrameter
