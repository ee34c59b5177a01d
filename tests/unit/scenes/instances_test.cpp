// SPDX-License-Identifier: Apache-2.0
// Without these a repeated mesh could be copied in silence, stand askew, or be lost by what knows only triangles.
#include "scenes/instances.h"

#include "core/files.h"
#include "scene_text.h"
#include "scenes/check_scene.h"
#include "scenes/choose_light.h"
#include "scenes/export_scene.h"
#include "scenes/light_enclosure.h"
#include "scenes/local_scene.h"
#include "scenes/merge_meshes.h"
#include "scenes/scene_hash.h"
#include "scenes/seen_from.h"
#include "scenes/shapes.h"
#include "tests/support/instanced_scene.h"
#include "tests/support/procedural_scene.h"
#include "tests/support/temporary_folder.h"

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

namespace umbrameter {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using Json = nlohmann::json;

const Light kLamp = rect_light_above({0, 4, 0}, {1, 1});

glm::dmat4 at(double x, double y = 0.0, double z = 0.0) {
  return glm::translate(glm::dmat4(1.0), glm::dvec3(x, y, z));
}

Scene boxes_at(const std::vector<glm::dmat4>& places, MeshData box = make_box({1, 2, 3})) {
  std::vector<NamedMesh> meshes(1);
  meshes[0].name = "box";
  meshes[0].label = "box.glb";
  meshes[0].mesh.repeated.push_back({std::move(box), places});
  Scene scene;
  merge_meshes(meshes, scene);
  return scene;
}

TEST(Instances, KeepTheirMeshOnceAndItsMirrorImage) {
  const Scene scene = instanced_scene(kLamp);
  ASSERT_EQ(scene.instanced.size(), 2u) << "four trees stand straight or turned over twice, two are mirrored";
  EXPECT_EQ(scene.instanced[0]->world_from_mesh.size(), 2u);
  EXPECT_EQ(scene.instanced[1]->world_from_mesh.size(), 4u);
  const size_t tree = scene.instanced[0]->triangles.size();
  EXPECT_EQ(scene.instanced[1]->triangles.size(), tree);
  EXPECT_EQ(scene.triangles.size(), 2u);
  EXPECT_EQ(count_shown_triangles(scene), 2 + 6 * tree);
  for (const auto& mesh : scene.instanced) {
    for (const glm::mat4x3& m : mesh->world_from_mesh)
      EXPECT_GT(glm::determinant(glm::mat3(m[0], m[1], m[2])), 0.0f);
  }
  EXPECT_THAT(check_scene(scene), IsEmpty()) << "closed, and outside is outside";
}

TEST(Instances, FlattenedStandWhereTheyDid) {
  for (const bool has_leaves : {false, true}) {
    const Scene scene = instanced_scene(kLamp, {.is_smooth = true, .has_leaves = has_leaves});
    const Scene flat = flattened(scene);
    EXPECT_TRUE(flat.instanced.empty());
    EXPECT_EQ(flat.triangles.size(), count_shown_triangles(scene));
    EXPECT_EQ(flat.cutouts.size(), count_shown_cutouts(scene));
    EXPECT_EQ(flat.normals_world.size(), flat.positions_world.size());
    EXPECT_NE(flat.hash, scene.hash);
    Bounds3 bounds;
    for (const glm::vec3& p : flat.positions_world) {
      bounds.min = glm::min(bounds.min, glm::dvec3(p));
      bounds.max = glm::max(bounds.max, glm::dvec3(p));
    }
    EXPECT_LT(glm::distance(bounds.min, scene.bounds_world.min), 1e-6);
    EXPECT_LT(glm::distance(bounds.max, scene.bounds_world.max), 1e-6);
    const std::vector<Instance> instances = list_instances(scene);
    ASSERT_EQ(instances.size(), 6u);
    for (const Instance& instance : instances) {
      for (uint32_t v = 0; v < instance.mesh->positions.size(); ++v) {
        const glm::dvec3 p = instance.p_world(v);
        EXPECT_TRUE(glm::all(glm::lessThanEqual(instance.bounds_world().min, p)));
        EXPECT_TRUE(glm::all(glm::lessThanEqual(p, instance.bounds_world().max)));
      }
      if (has_leaves) continue;  // what has holes stands last in the flattened scene
      const glm::uvec3& t = flat.triangles[instance.first_shown + 5];
      const auto corners = instance.corners_world(5);
      EXPECT_LT(glm::distance(corners[1], glm::dvec3(flat.positions_world[t.y])), 1e-6);
      EXPECT_LT(
          glm::distance(instance.n_world(instance.mesh->triangles[5].z), glm::dvec3(flat.normals_world[t.z])),
          1e-6);
    }
  }
}

TEST(Instances, ThatMirrorOrStretchFaceOutwards) {
  for (const glm::dmat4& place :
       {at(3), glm::scale(at(3), glm::dvec3(-1, 1, 1)), glm::scale(at(3), glm::dvec3(2, -0.3, 1)),
        glm::scale(at(3), glm::dvec3(-1, -1, -2))}) {
    const Scene flat = flattened(boxes_at({at(0), place}));
    double volume = 0.0;  // six times
    for (const glm::uvec3& t : flat.triangles) {
      const auto p = [&](uint32_t v) { return glm::dvec3(flat.positions_world[v]); };
      volume += glm::dot(p(t.x), glm::cross(p(t.y), p(t.z)));
    }
    const double expected = 6.0 * (1.0 + std::abs(glm::determinant(glm::dmat3(place)))) * 6.0;
    EXPECT_NEAR(volume, expected, 1e-4);
  }
}

TEST(Instances, InOnePlaceAreDroppedWithAWord) {
  const Scene scene = boxes_at({at(0), at(5), at(0), at(5), at(0)});
  EXPECT_EQ(scene.instanced.front()->world_from_mesh.size(), 2u);
  EXPECT_THAT(scene.warnings, ElementsAre("box.glb: dropped 3 instances that stood where another does"));
}

TEST(Instances, AreCleanedAsOtherMeshesAre) {
  MeshData box = make_box({1, 1, 1});
  box.triangles.push_back(box.triangles.front());
  box.triangles.push_back({0, 0, 1});
  const Scene scene = boxes_at({at(0), at(5)}, box);
  EXPECT_EQ(scene.instanced.front()->triangles.size(), 12u);
  EXPECT_THAT(scene.warnings, ElementsAre("box.glb: dropped 1 triangle of zero area, 1 duplicate"));
}

TEST(Instances, TooFarAwayAreRefused) {
  EXPECT_THAT(message_of([] {
                boxes_at({at(0), at(1e9)});
              }),
              HasSubstr("an instance of mesh 'box' has a vertex at"));
}

TEST(Instances, RuleByCopiedTrianglesAndFlatPlaces) {
  const std::vector<glm::dmat4> two{at(0), at(1)}, eleven(11, at(0));
  EXPECT_FALSE(is_kept_once(kLeastCopiedTriangles - 1, two));
  EXPECT_TRUE(is_kept_once(kLeastCopiedTriangles, two));
  EXPECT_FALSE(is_kept_once(10 * kLeastCopiedTriangles, std::span(two).first(1)));
  EXPECT_TRUE(is_kept_once(kLeastCopiedTriangles / 10, eleven));
  const glm::dmat4 squashed = glm::scale(at(0), glm::dvec3(1, 0, 1));
  EXPECT_FALSE(is_kept_once(kLeastCopiedTriangles, std::vector{at(0), squashed}));
  EXPECT_TRUE(is_kept_once(kLeastCopiedTriangles, std::vector{at(0), squashed, at(2)})) << "the others count";
}

TEST(Instances, OneFlatPlaceHasACopyAndTheOthersStay) {
  MeshData leafy = make_box({1, 2, 3});
  leafy.parts = {{"walls", 0, 12}};
  leafy.cutout_of_triangle.assign(12, kSolid);
  leafy.cutout_of_triangle[5] = 0;
  leafy.cutouts = {{{glm::vec2(0, 0), glm::vec2(1, 0), glm::vec2(0, 1)}, 0}};
  leafy.masks = {AlphaMask{"m", 1, 1, {1}}};
  const glm::dmat4 flat = glm::scale(at(5), glm::dvec3(-1, 1, 0));
  for (const bool is_smooth : {false, true}) {
    if (is_smooth) split_flat(leafy);
    const Scene scene = boxes_at({at(0), flat, at(9)}, leafy);
    ASSERT_EQ(scene.instanced.size(), 1u);
    EXPECT_EQ(scene.instanced[0]->world_from_mesh.size(), 2u);
    EXPECT_EQ(scene.triangles.size(), 2u) << "front and back of the box are one and the same now";
    EXPECT_EQ(scene.normals_world.empty(), !is_smooth);
    EXPECT_EQ(scene.bounds_world.max.x, 9.5);
    for (const glm::vec3& p : scene.positions_world) EXPECT_EQ(p.z, 0.0f);
    for (uint32_t v = 0; v < scene.normals_world.size(); ++v)
      EXPECT_NEAR(std::abs(scene.normals_world[v].z), 1.0f, 1e-6f);
  }
}

TEST(Instances, HolesOfAMeshAndItsMirrorImageAreSaidOnce) {
  MeshData ball = make_sphere(0.5, 24, false);
  ball.triangles.pop_back();
  Scene scene = boxes_at({at(0), at(2), glm::scale(at(4), glm::dvec3(-1, 1, 1))}, ball);
  scene.camera = {.eye_world = {0, 0, 9}, .at_world = {0, 0, 0}, .near_world = 1e-3};
  ASSERT_EQ(scene.instanced.size(), 2u);
  EXPECT_THAT(check_scene(scene), ElementsAre(HasSubstr("'box' is not closed: 3 of")));
}

TEST(Instances, AreNumberedAsFarAsAFloatTells) {
  EXPECT_EQ(shown_id(kMaxTriangles), kMaxTriangles);
  EXPECT_EQ(shown_id(kMaxTriangles + 1), 0u);
  EXPECT_EQ(shown_id(3 * (kMaxTriangles + 1) + 7), 7u);
}

TEST(Instances, ChangeTheHash) {
  const Scene scene = instanced_scene(kLamp);
  Scene without = scene;
  without.instanced.clear();
  EXPECT_NE(hash_scene(without), scene.hash);
  Scene moved = scene;
  auto mesh = std::make_shared<InstancedMesh>(*scene.instanced[0]);
  mesh->world_from_mesh[0][3].x += 1e-3f;
  moved.instanced[0] = mesh;
  EXPECT_NE(hash_scene(moved), scene.hash);
}

TEST(Instances, AreExportedEachOnItsOwn) {
  const Scene scene = boxes_at({at(0), at(5)});
  const std::string text = scene_obj_text(scene);
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 1 + 16 + 2 + 24);
  EXPECT_EQ(Json::parse(scene_json_text(instanced_scene(kLamp), "x", 4, 4)).at("triangles"),
            count_shown_triangles(instanced_scene(kLamp)));
}

TEST(Instances, FarFromTheOriginMoveWithTheScene) {
  Scene scene = boxes_at({at(1000, 0, -500), at(1005, 0, -500)});
  scene.lights = {kLamp};
  scene.camera.eye_world = {1002, 3, -490};
  scene.camera.at_world = {1002, 0, -500};
  const auto local = local_scene(scene);
  ASSERT_TRUE(local);
  const Instance was = list_instances(scene)[1], is = list_instances(local->scene)[1];
  EXPECT_EQ(is.p_world(3) + local->origin_world, was.p_world(3));
  EXPECT_LT(glm::length(is.p_world(3)), 32.0);
}

TEST(Instances, AroundALightAreSaid) {
  Scene scene = boxes_at({at(0), at(50), at(60)}, make_box({4, 9, 4}));
  Light light = kLamp;
  light.name = "lamp";
  scene.lights = {light};
  scene.camera.eye_world = {0, 3, 30};
  EXPECT_THAT(find_enclosed_lights(scene), ElementsAre("light 'lamp' seems to be inside 'box'"));
}

TEST(SharedScene, CamerasAndLightsShareItsGeometry) {
  const Scene scene = instanced_scene(kLamp);
  Camera camera = scene.camera;
  camera.eye_world.x += 1;
  const Scene moved = seen_from(scene, camera);
  EXPECT_NE(moved.hash, scene.hash);
  EXPECT_TRUE(moved.positions_world.is_one_with(scene.positions_world));
  EXPECT_TRUE(moved.triangles.is_one_with(scene.triangles));
  EXPECT_EQ(moved.instanced, scene.instanced);
  EXPECT_TRUE(lit_by(scene, 0).triangles.is_one_with(scene.triangles));
  Scene own = scene;
  own.triangles.edit().pop_back();
  EXPECT_EQ(own.triangles.size() + 1, scene.triangles.size());
}

/// A glTF file of a grid of n x n quads, shown by a node at each of `places`.
class RepeatedGltf : public testing::Test {
 protected:
  Scene load(int n, const Json& nodes) const {
    std::string bytes;
    const auto add = [&bytes](auto value) {
      bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
    };
    for (int y = 0; y <= n; ++y) {
      for (int x = 0; x <= n; ++x) {
        add(static_cast<float>(x) / static_cast<float>(n));
        add(static_cast<float>(y) / static_cast<float>(n));
        add(0.0f);
      }
    }
    const size_t positions = bytes.size();
    const auto vertex = [n](int x, int y) { return static_cast<uint32_t>(y * (n + 1) + x); };
    for (int y = 0; y < n; ++y) {
      for (int x = 0; x < n; ++x) {
        for (const uint32_t v : {vertex(x, y), vertex(x + 1, y), vertex(x + 1, y + 1), vertex(x, y),
                                 vertex(x + 1, y + 1), vertex(x, y + 1)})
          add(v);
      }
    }
    Json json = Json::parse(R"({"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": []}],
      "meshes": [{"name": "grid", "primitives": [{"attributes": {"POSITION": 0}, "indices": 1}]}]})");
    json["nodes"] = nodes;
    for (size_t i = 0; i < nodes.size(); ++i) json["scenes"][0]["nodes"].push_back(i);
    json["accessors"] = {
        {{"bufferView", 0}, {"componentType", 5126}, {"count", (n + 1) * (n + 1)}, {"type", "VEC3"}},
        {{"bufferView", 1}, {"componentType", 5125}, {"count", 6 * n * n}, {"type", "SCALAR"}}};
    json["bufferViews"] = {
        {{"buffer", 0}, {"byteOffset", 0}, {"byteLength", positions}},
        {{"buffer", 0}, {"byteOffset", positions}, {"byteLength", bytes.size() - positions}}};
    json["buffers"] = {{{"byteLength", bytes.size()}, {"uri", "grid.bin"}}};
    write_file_atomically(folder_.path() / "grid.bin", bytes);
    write_file_atomically(folder_.path() / "grid.gltf", json.dump());
    return load_scene(folder_.path() / "grid.gltf", {});
  }
  const std::filesystem::path& folder() const { return folder_.path(); }

 private:
  TemporaryFolder folder_;
};

TEST_F(RepeatedGltf, KeepsAMeshOnceThatManyNodesShow) {
  const Json nodes =
      Json::parse(R"([{"name": "a", "mesh": 0}, {"name": "b", "mesh": 0, "translation": [3, 0, 0]},
      {"name": "c", "mesh": 0, "translation": [6, 0, 0], "scale": [1, -2, 1]}])");
  const Scene large = load(160, nodes);
  ASSERT_EQ(large.instanced.size(), 2u);
  EXPECT_EQ(large.instanced[1]->triangles.size(), 2u * 160 * 160);
  EXPECT_EQ(large.instanced[1]->world_from_mesh.size(), 2u);
  EXPECT_TRUE(large.triangles.empty());
  EXPECT_EQ(large.bounds_world.max, glm::dvec3(7, 1, 0));
  EXPECT_EQ(large.bounds_world.min, glm::dvec3(0, -2, 0));
  EXPECT_EQ(large.instanced[1]->parts.front().name, "grid/grid");

  const Scene small = load(20, nodes);
  EXPECT_TRUE(small.instanced.empty());
  EXPECT_EQ(small.triangles.size(), 3u * 2 * 20 * 20);
  EXPECT_EQ(small.bounds_world.max, large.bounds_world.max);
}

TEST_F(RepeatedGltf, StandsInSeveralPlacesOfASceneFile) {
  const Json one = Json::parse(R"([{"name": "a", "mesh": 0}])");
  load(250, one);
  const std::string head =
      "[camera]\neye = [0, 3, 9]\nat = [0, 0, 0]\n[[light]]\ntype = \"sun\"\nangular_diameter_deg = "
      "1\ndirection = [0, -1, 0.1]\n";
  const std::string first = "[[mesh]]\nfile = \"grid.gltf\"\n",
                    second = first + "translate = [4, 0, 0]\nup = \"z\"\n";
  const Scene scene = parse_scene(head + first + second, folder() / "x.toml", {});
  ASSERT_EQ(scene.instanced.size(), 1u);
  EXPECT_EQ(scene.instanced[0]->world_from_mesh.size(), 2u);
  EXPECT_EQ(scene.bounds_world.max, glm::dvec3(5, 1, 0));
  EXPECT_EQ(scene.bounds_world.min, glm::dvec3(0, 0, -1));
  const Scene other = parse_scene(head + first + second + "include = [\"grid\"]\n", folder() / "x.toml", {});
  EXPECT_TRUE(other.instanced.empty()) << "another filter may keep other triangles";
}

}  // namespace
}  // namespace umbrameter
