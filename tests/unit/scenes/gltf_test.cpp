// SPDX-License-Identifier: Apache-2.0
// Without these a scene from another program could stand askew, lose a light, or fill the leaves' holes without a word.
#include "scenes/gltf/gltf_mesh.h"
#include "scenes/import_scene.h"

#include "core/files.h"
#include "scene_text.h"
#include "tests/support/glb_file.h"
#include "tests/support/temporary_folder.h"

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include <glm/geometric.hpp>

#include <cstring>

namespace umbrameter {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using Json = nlohmann::json;

// 2 x 2 texels; alpha 255, 0 above 128, 127.
const std::string kPicture =
    "data:image/"
    "png;base64,iVBORw0KGgoAAAANSUhEUgAAAAIAAAACCAYAAABytg0kAAAAEUlEQVR42mP4DwEMINAAxPUAZK8H+efZcbkAAAAASUVOR"
    "K5CYII=";

/// A square in the xy plane from 0 to 1, facing +z: positions, texture points and indices in one buffer.
struct Square {
  std::string bytes;
  Json json;

  Square() {
    const float positions[12] = {0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0};
    const float points[8] = {0, 1, 1, 1, 1, 0, 0, 0};  // v counts downwards
    const uint16_t indices[6] = {0, 1, 2, 0, 2, 3};
    bytes.append(reinterpret_cast<const char*>(positions), sizeof positions);
    bytes.append(reinterpret_cast<const char*>(points), sizeof points);
    bytes.append(reinterpret_cast<const char*>(indices), sizeof indices);
    json = Json::parse(R"({
      "asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}],
      "nodes": [{"name": "root", "mesh": 0}],
      "meshes": [{"name": "square", "primitives": [{"attributes": {"POSITION": 0, "TEXCOORD_0": 1}, "indices": 2}]}],
      "accessors": [
        {"bufferView": 0, "componentType": 5126, "count": 4, "type": "VEC3", "min": [0, 0, 0], "max": [1, 1, 0]},
        {"bufferView": 1, "componentType": 5126, "count": 4, "type": "VEC2"},
        {"bufferView": 2, "componentType": 5123, "count": 6, "type": "SCALAR"}],
      "bufferViews": [{"buffer": 0, "byteOffset": 0, "byteLength": 48}, {"buffer": 0, "byteOffset": 48, "byteLength": 32},
                      {"buffer": 0, "byteOffset": 80, "byteLength": 12}],
      "buffers": [{"byteLength": 92}]})");
  }

  std::string glb() const { return glb_of(json, bytes); }
};

class Gltf : public testing::Test {
 protected:
  GltfFile open(const std::string& bytes, const std::string& name = "x.glb") const {
    write_file_atomically(folder_.path() / name, bytes);
    return open_gltf(folder_.path() / name);
  }
  MeshData load(const Square& square, const MeshFilter& filter = {}) {
    warnings_.clear();
    return load_gltf_mesh(open(square.glb()), filter, warnings_);
  }
  std::string error_of(const Square& square) {
    return after_folder(message_of([&] { load(square); }));
  }
  std::string after_folder(const std::string& message) const {
    const std::string folder = folder_.path().string() + "/";
    EXPECT_EQ(message.substr(0, folder.size()), folder);
    return message.substr(std::min(folder.size(), message.size()));
  }
  ImportedScene import(const Square& square) const {
    write_file_atomically(folder_.path() / "x.glb", square.glb());
    return import_file(folder_.path() / "x.glb");
  }

  TemporaryFolder folder_;
  std::vector<std::string> warnings_;
};

TEST_F(Gltf, ReadsASquare) {
  const MeshData mesh = load({});
  EXPECT_THAT(mesh.triangles, ElementsAre(glm::uvec3(0, 1, 2), glm::uvec3(0, 2, 3)));
  EXPECT_EQ(mesh.positions.at(2), glm::dvec3(1, 1, 0));
  EXPECT_TRUE(mesh.normals.empty());
  EXPECT_TRUE(mesh.cutouts.empty());
  ASSERT_EQ(mesh.parts.size(), 1u);
  EXPECT_EQ(mesh.parts[0].name, "square");
  EXPECT_THAT(warnings_, IsEmpty());
}

TEST_F(Gltf, NodesStandInTheirParents) {
  Square square;
  square.json["nodes"] = Json::parse(R"([
    {"translation": [10, 0, 0], "scale": [2, 2, 2], "children": [1, 2]},
    {"rotation": [0, 0.7071067811865476, 0, 0.7071067811865476], "mesh": 0},
    {"matrix": [-1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 3, 0, 1], "mesh": 0}])");
  const MeshData mesh = load(square);
  ASSERT_EQ(mesh.positions.size(), 8u);
  EXPECT_NEAR(glm::distance(mesh.positions[1], glm::dvec3(10, 0, -2)), 0.0, 1e-12)
      << "a quarter turn about y";
  EXPECT_EQ(mesh.positions[5], glm::dvec3(8, 6, 0)) << "mirrored, then scaled";
  EXPECT_EQ(mesh.triangles[2], glm::uvec3(4, 6, 5)) << "so that it still faces +z";
}

TEST_F(Gltf, StripsFansAndPlainVertices) {
  Square square;
  Json& primitive = square.json["meshes"][0]["primitives"][0];
  primitive.erase("indices");
  primitive["mode"] = 6;
  EXPECT_THAT(load(square).triangles, ElementsAre(glm::uvec3(0, 1, 2), glm::uvec3(0, 2, 3)));
  primitive["mode"] = 5;
  EXPECT_THAT(load(square).triangles, ElementsAre(glm::uvec3(0, 1, 2), glm::uvec3(1, 3, 2)));
}

TEST_F(Gltf, MasksAreHolesByTheirOwnCutoff) {
  Square square;
  square.json["materials"] = Json::parse(
      R"([{"name": "leaf", "alphaMode": "MASK", "pbrMetallicRoughness": {"baseColorTexture": {"index": 0}}}])");
  square.json["textures"] = Json::parse(R"([{"source": 0}])");
  square.json["images"] = Json::array({{{"uri", kPicture}}});
  square.json["meshes"][0]["primitives"][0]["material"] = 0;
  const MeshData mesh = load(square);
  ASSERT_EQ(mesh.masks.size(), 1u);
  EXPECT_THAT(mesh.masks[0].bits, ElementsAre(0b0101u));
  ASSERT_EQ(mesh.cutouts.size(), 2u);
  EXPECT_EQ(mesh.cutouts[0].uv, (std::array{glm::vec2(0, 0), glm::vec2(1, 0), glm::vec2(1, 1)}))
      << "v upwards";
  EXPECT_EQ(mesh.parts[0].name, "leaf");
  EXPECT_THAT(warnings_, IsEmpty());
  square.json["materials"][0]["alphaCutoff"] = 0.51;
  EXPECT_THAT(load(square).masks[0].bits, ElementsAre(0b0100u));
  square.json["materials"][0]["pbrMetallicRoughness"]["baseColorFactor"] = {1, 1, 1, 0.1};
  EXPECT_THAT(load(square).masks[0].bits, ElementsAre(0u));
  square.json["materials"][0] =
      Json::parse(R"({"name": "glass", "alphaMode": "BLEND", "pbrMetallicRoughness": {
      "baseColorFactor": [1, 1, 1, 0.2]}})");
  EXPECT_EQ(load(square).cutouts.size(), 2u);
  EXPECT_THAT(warnings_,
              ElementsAre(HasSubstr("material 'glass' blends: it is solid from an alpha of 0.5 on")));
  square.json["materials"][0]["alphaMode"] = "OPAQUE";
  EXPECT_TRUE(load(square).cutouts.empty());
}

TEST_F(Gltf, CamerasAndLightsWithTheirSizes) {
  Square square;
  square.json["cameras"] =
      Json::parse(R"([{"type": "perspective", "perspective": {"yfov": 0.5, "znear": 0.1}}])");
  square.json["extensions"] = Json::parse(R"({"KHR_lights_punctual": {"lights": [
    {"type": "point", "name": "bulb"}, {"type": "directional"}, {"type": "spot", "spot": {}}]}})");
  square.json["nodes"] = Json::parse(R"([
    {"mesh": 0, "children": [1, 2, 3, 4, 5]},
    {"name": "eye", "camera": 0, "translation": [0.5, 0.5, 4]},
    {"name": "bulb", "translation": [0, 2, 1], "extras": {"radius": 0.25}, "extensions": {"KHR_lights_punctual": {"light": 0}}},
    {"name": "sky", "rotation": [-0.7071067811865476, 0, 0, 0.7071067811865476],
     "extensions": {"KHR_lights_punctual": {"light": 1}}},
    {"name": "panel", "translation": [0, 3, 0], "extras": {"size": [2, 1]}, "extensions": {"KHR_lights_punctual": {"light": 2}}},
    {"name": "door", "camera": 0}])");
  const ImportedScene imported = import(square);
  EXPECT_THAT(imported.warnings, testing::UnorderedElementsAre(
                                     "x.glb: it has 2 cameras; the scene is seen from that of node 'eye'",
                                     "x.glb: light 'sky' has no angular diameter in degrees; 0.53 is taken"));
  const Scene scene = load_scene(folder_.path() / "x.glb", {});
  EXPECT_EQ(scene.triangles.size(), 2u);
  EXPECT_EQ(scene.warnings.size(), 2u);
  EXPECT_EQ(scene.camera.eye_world, glm::dvec3(0.5, 0.5, 4));
  EXPECT_EQ(scene.camera.at_world, glm::dvec3(0.5, 0.5, 0));
  EXPECT_NEAR(scene.camera.vertical_fov_deg, 28.64788975654116, 1e-12);
  ASSERT_EQ(scene.lights.size(), 3u);
  EXPECT_EQ(scene.lights[0].type, LightType::sphere);
  EXPECT_EQ(scene.lights[0].radius_world, 0.25);
  EXPECT_EQ(scene.lights[1].type, LightType::sun);
  EXPECT_NEAR(scene.lights[1].direction_world.y, -1.0, 1e-12);
  EXPECT_EQ(scene.lights[2].type, LightType::rect);
  EXPECT_EQ(scene.lights[2].size_world, glm::dvec2(2, 1));
  EXPECT_EQ(scene.lights[2].name, "panel");
  EXPECT_EQ(scene.lights[2].direction_world, glm::dvec3(0, 0, -1));
}

TEST_F(Gltf, AFileWithoutCameraAndLightGetsBothAndSaysSo) {
  const ImportedScene imported = import({});
  EXPECT_EQ(imported.warnings.size(), 2u);
  const Scene scene = load_scene(folder_.path() / "x.glb", {});
  EXPECT_EQ(scene.lights.size(), 1u);
  EXPECT_EQ(scene.light().type, LightType::sun);
}

TEST_F(Gltf, FiltersGoByMaterialMeshOrNode) {
  EXPECT_EQ(load({}, {.include = {"root"}, .exclude = {}}).triangles.size(), 2u);
  EXPECT_EQ(after_folder(message_of([&] { load({}, {.include = {"rot"}, .exclude = {}}); })),
            "x.glb: no material, mesh or node is called 'rot' (did you mean 'root'?)");
  EXPECT_EQ(after_folder(message_of([&] { load({}, {.include = {}, .exclude = {"square"}}); })),
            "x.glb: the file has no triangles");
}

TEST_F(Gltf, BadFilesAreSentences) {
  const std::string glb = Square().glb();
  for (size_t length : {size_t{0}, size_t{3}, size_t{19}})
    EXPECT_EQ(after_folder(message_of([&] { open(glb.substr(0, length)); })),
              "x.glb: this is no GLB file: it does not begin with 'glTF'");
  for (size_t length : {size_t{20}, size_t{200}, glb.size() - 1})
    EXPECT_EQ(after_folder(message_of([&] { open(glb.substr(0, length)); })),
              fmt::format("x.glb: the file is cut off: it has {} of {} bytes", length, glb.size()));
  EXPECT_THAT(message_of([&] { open("{\"asset\": {", "x.gltf"); }),
              HasSubstr("x.gltf: not a readable glTF file: "));
  Square square;
  square.json["buffers"][0]["uri"] = "gone.bin";
  EXPECT_THAT(message_of([&] { open(square.json.dump(), "x.gltf"); }), HasSubstr("gone.bin"));
}

TEST_F(Gltf, ContentsThatDoNotHoldTogetherAreSentences) {
  Square square;
  square.json["nodes"][0]["children"] = {0};
  EXPECT_EQ(error_of(square), "x.glb: node 'root' is its own ancestor or has two parents");
  square = {};
  square.json["nodes"][0]["scale"] = {1e308, 1, 1};
  square.json["nodes"][0]["children"] = {1};
  square.json["nodes"].push_back({{"scale", {1e308, 1, 1}}});
  EXPECT_EQ(error_of(square), "x.glb: the transform of node 1 is not finite");
  square = {};
  square.json["accessors"][2]["count"] = 1000000000;
  EXPECT_EQ(error_of(square),
            "x.glb: accessor 2 (indices) wants 1000000000 elements, more than its buffer holds");
  square = {};
  square.json["bufferViews"][0]["byteOffset"] = 4000000000u;
  EXPECT_THAT(error_of(square), HasSubstr("x.glb: "));
  square = {};
  square.bytes[80] = 4;
  EXPECT_EQ(error_of(square), "x.glb: a primitive of node 'root' refers to vertex 4, but has 4");
  square = {};
  square.json["nodes"][0]["mesh"] = 7;
  EXPECT_EQ(error_of(square), "x.glb: node 'root' names mesh 7, but there are 1");
  square = {};
  square.json["extensionsRequired"] = {"KHR_draco_mesh_compression"};
  EXPECT_THAT(error_of(square),
              HasSubstr("requires extension 'KHR_draco_mesh_compression', which is not read"));
  square = {};
  square.json["meshes"][0]["primitives"][0]["attributes"].erase("POSITION");
  EXPECT_EQ(error_of(square), "x.glb: a primitive of node 'root' has no positions");
}

TEST_F(Gltf, WhatIsLeftOutIsCounted) {
  Square square;
  Json lines = square.json["meshes"][0]["primitives"][0];
  lines["mode"] = 1;
  square.json["meshes"][0]["primitives"].push_back(lines);
  square.json["animations"] = Json::parse(R"([{"channels": [], "samplers": []}])");
  load(square);
  EXPECT_THAT(
      warnings_,
      ElementsAre("x.glb: 1 animation is not shown ('animation 1'): 'time' or --time chooses a moment",
                  "x.glb: 1 primitive of points or lines is left out"));
}

}  // namespace
}  // namespace umbrameter
