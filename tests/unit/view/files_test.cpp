// SPDX-License-Identifier: Apache-2.0
// Without this what the window saves could be read back as something else.

#include "core/files.h"
#include "scenes/load_scene.h"
#include "tests/support/glb_file.h"
#include "tests/support/source_dir.h"
#include "tests/support/temporary_folder.h"
#include "view/camera_path.h"
#include "view/light_edit.h"
#include "view/scene_text.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

namespace umbrameter {
namespace {

using testing::HasSubstr;
using testing::Not;

void expect_equal(const Camera& a, const Camera& b) {
  EXPECT_EQ(a.eye_world, b.eye_world);
  EXPECT_EQ(a.at_world, b.at_world);
  EXPECT_EQ(a.vertical_fov_deg, b.vertical_fov_deg);
  EXPECT_EQ(a.near_world, b.near_world);
}

class ViewFiles : public testing::Test {
 protected:
  Scene load(const std::filesystem::path& file) { return load_scene(file, {}); }
  std::filesystem::path library(const std::string& name) {
    return source_dir() / "scenes" / "library" / name;
  }
  std::filesystem::path place(const std::string& name) { return folder_.path() / name; }

 private:
  TemporaryFolder folder_;
};

TEST_F(ViewFiles, SavedSceneIsTheSceneWithItsCameraToTheLastBit) {
  for (const char* name : {"plate.toml", "under_a_bulb.toml", "half_plane_disk.toml", "fence.toml"}) {
    const Scene scene = load(library(name));
    Camera camera = scene.camera;
    camera.eye_world = {1.0 / 3.0, 2.1, -0.7};
    write_file_atomically(place("saved.toml"),
                          scene_toml(scene, {}, place("saved.toml"), camera, scene.light()));
    const Scene saved = load(place("saved.toml"));
    expect_equal(saved.camera, camera);
    EXPECT_EQ(saved.triangles.size(), scene.triangles.size());
    EXPECT_EQ(saved.title, scene.title);
    ASSERT_EQ(saved.lights.size(), 1u);
    EXPECT_EQ(saved.light().type, scene.light().type);
    EXPECT_EQ(saved.light().center_world, scene.light().center_world);
    EXPECT_EQ(saved.light().size_world, scene.light().size_world);
    EXPECT_EQ(saved.light().radius_world, scene.light().radius_world);
    EXPECT_NEAR(saved.light().half_angle_rad, scene.light().half_angle_rad, 1e-15);
    EXPECT_LT(glm::distance(saved.light().direction_world, scene.light().direction_world), 1e-15);
    EXPECT_LT(glm::distance(saved.light().tangent_world, scene.light().tangent_world), 1e-15);
  }
}

TEST_F(ViewFiles, SavedSceneFindsMeshesThatLayBesideItsOwn) {
  write_file_atomically(place("triangle.obj"), "v 0 0 0\nv 1 0 0\nv 0 0 -1\nf 1 2 3\n");
  write_file_atomically(
      place("own.toml"),
      "title = \"one\"\n[camera]\neye = [0, 3, 3]\nat = [0, 0, 0]\n[[mesh]]\nname = \"t\"\n"
      "file = \"triangle.obj\"\n[[light]]\ntype = \"sphere\"\ncenter = [0, 2, 0]\nradius = 0.1\n"
      "direction = [0, -1, 0]\n");
  const Scene scene = load(place("own.toml"));
  create_folder(place("elsewhere"));
  write_file_atomically(place("elsewhere/saved.toml"),
                        scene_toml(scene, {}, place("elsewhere/saved.toml"), scene.camera, scene.light()));
  EXPECT_EQ(load(place("elsewhere/saved.toml")).triangles.size(), 1u);
}

TEST_F(ViewFiles, SavedSceneShowsTheMomentThatWasChosen) {
  GlbFile file;
  file.add_square_mesh();
  file.json["nodes"] = nlohmann::json::parse(R"([{"mesh": 0}])");
  file.animate(0, "translation", {0, 1}, {0, 0, 0, 4, 0, 0}, "VEC3", "LINEAR", 0, "go");
  write_file_atomically(place("x.glb"), file.glb());
  write_file_atomically(
      place("own.toml"),
      "[camera]\neye = [0, 3, 3]\nat = [0, 0, 0]\n[[mesh]]\nshape = \"plane\"\nsize = [4, 4]\n[[mesh]]\n"
      "time = 0.75\nfile = \"x.glb\"\n[[light]]\ntype = \"sphere\"\ncenter = [0, 2, 0]\nradius = 0.1\n"
      "direction = [0, -1, 0]\n");
  for (const char* name : {"own.toml", "x.glb"}) {
    SceneSearch search;
    search.at = AnimationTime{0.25, "go"};
    const Scene scene = load_scene(place(name), search);
    write_file_atomically(place("saved.toml"),
                          scene_toml(scene, search.at, place("saved.toml"), scene.camera, scene.light()));
    const Scene saved = load(place("saved.toml"));
    ASSERT_EQ(saved.animated.size(), 1u) << name;
    EXPECT_EQ(saved.animated[0].time_s, 0.25) << name;
    EXPECT_EQ(saved.hash, scene.hash) << name;
  }
}

TEST_F(ViewFiles, SceneInOneLineIsRefusedInsteadOfLosingItsCamera) {
  write_file_atomically(
      place("own.toml"),
      "camera = { eye = [0, 3, 3], at = [0, 0, 0] }\n[[mesh]]\nname = \"t\"\nshape = \"plane\"\n"
      "size = [1, 1]\n[[light]]\ntype = \"sphere\"\ncenter = [0, 2, 0]\nradius = 0.1\n"
      "direction = [0, -1, 0]\n");
  const Scene scene = load(place("own.toml"));
  try {
    scene_toml(scene, {}, place("saved.toml"), scene.camera, scene.light());
    FAIL() << "saved";
  } catch (const Error& error) {
    EXPECT_THAT(error.what(), HasSubstr("[camera] is not a table of its own"));
  }
}

TEST_F(ViewFiles, PathComesBackToTheLastBitAndIsLinearBetween) {
  Camera first, second;
  first.near_world = second.near_world = 0.01;
  second.eye_world = {1.0 / 3.0, 0.2, 5.0};
  const std::vector<CameraKey> path{{0.0, first}, {2.0, second}};
  write_file_atomically(place("flight.path.toml"), camera_path_toml(path));
  const std::vector<CameraKey> read = read_camera_path(place("flight.path.toml"), 1.0);
  ASSERT_EQ(read.size(), 2u);
  expect_equal(read[1].camera, second);
  EXPECT_EQ(camera_at(read, -1.0).eye_world, first.eye_world);
  EXPECT_EQ(camera_at(read, 9.0).eye_world, second.eye_world);
  EXPECT_NEAR(camera_at(read, 0.5).eye_world.z, 2.0, 1e-12);  // a quarter of the way from 1 to 5
}

TEST_F(ViewFiles, PathThatRunsBackwardsIsRefusedAtItsLine) {
  Camera camera;
  camera.near_world = 0.01;
  write_file_atomically(place("bad.toml"), camera_path_toml({{1.0, camera}, {1.0, camera}}));
  try {
    read_camera_path(place("bad.toml"), 0.1);
    FAIL() << "read";
  } catch (const Error& error) {
    EXPECT_THAT(error.what(), HasSubstr("'time_s' = 1 does not rise"));
    EXPECT_GT(error.where().line, 1);
  }
}

TEST(ViewPreset, HoldsWhatIsNotTheDefaultAlone) {
  Parameter kept, changed;
  kept.name = "search_taps";
  kept.default_value = int64_t{16};
  changed.name = "bias_texels";
  changed.default_value = 0.1;
  const std::vector<Parameter> parameters{kept, changed};
  const std::string text =
      view_preset_toml("pcss", parameters, {{"search_taps", int64_t{16}}, {"bias_texels", 2.0}});
  EXPECT_THAT(text, HasSubstr("technique = \"pcss\""));
  EXPECT_THAT(text, HasSubstr("bias_texels = 2.0\n"));
  EXPECT_THAT(text, Not(HasSubstr("search_taps")));
}

TEST(LightEdit, AtTheCameraItFacesWhatTheCameraSees) {
  Camera camera;
  camera.eye_world = {1, 2, 3};
  camera.at_world = {1, 2, 0};
  Light light;
  light.size_world = {0.8, 0.4};
  const Light moved = at_camera(light, camera);
  EXPECT_EQ(moved.center_world, glm::dvec3(1, 2, 3));
  EXPECT_EQ(moved.direction_world, glm::dvec3(0, 0, -1));
  EXPECT_NEAR(glm::dot(moved.tangent_world, moved.direction_world), 0.0, 1e-15);
  EXPECT_NEAR(glm::length(moved.bitangent_world), 1.0, 1e-15);
  EXPECT_EQ(moved.size_world, light.size_world);
}

TEST(LightEdit, ADragToTheRightTakesTheLightThere) {
  Camera camera;  // at z = 1, looking along -z: right is +x
  Light light;
  light.center_world = {0, 0, 0.5};  // between the camera and what it looks at
  light.direction_world = {0, 0, -1};
  light.tangent_world = {1, 0, 0};
  const Light right = swung(light, camera, glm::radians(90.0), 0.0),
              up = swung(light, camera, 0.0, glm::radians(90.0));
  EXPECT_LT(glm::distance(right.center_world, glm::dvec3(0.5, 0, 0)), 1e-12);
  EXPECT_LT(glm::distance(right.direction_world, glm::dvec3(-1, 0, 0)),
            1e-12);  // as it faced the middle before
  EXPECT_LT(glm::distance(up.center_world, glm::dvec3(0, 0.5, 0)), 1e-12);
}

TEST(LightEdit, StraightDownKeepsItsTangent) {
  Light light;
  light.tangent_world = {1, 0, 0};
  EXPECT_EQ(facing(light, {0, -3, 0}).tangent_world, glm::dvec3(1, 0, 0));
}

}  // namespace
}  // namespace umbrameter
