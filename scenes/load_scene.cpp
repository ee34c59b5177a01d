// SPDX-License-Identifier: Apache-2.0
#include "scenes/load_scene.h"

#include "core/files.h"
#include "scenes/import_scene.h"
#include "scenes/light_enclosure.h"
#include "scenes/read_camera.h"
#include "scenes/read_light.h"
#include "scenes/read_mesh.h"
#include "scenes/read_motion.h"
#include "scenes/rounding.h"
#include "scenes/scene_hash.h"
#include "scenes/seen_from.h"

#include <fmt/format.h>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <set>

namespace umbrameter {
namespace {

constexpr double kNearOfDiagonal = 1e-4;
constexpr double kNearOfTarget = 1e-2;

/// Before what the camera looks at, however large the scene is. Depth is reversed, so a small one costs nothing.
double derived_near(const Scene& scene) {
  const double to_target = glm::distance(scene.camera.eye_world, scene.camera.at_world);
  return std::min(kNearOfDiagonal * scene.bounds_world.diagonal(), kNearOfTarget * to_target);
}

/// Lights without a name are called by their type, the second of a type "disk-2".
void name_lights(std::vector<Light>& lights, std::set<std::string> taken) {
  for (Light& light : lights) {
    if (!light.name.empty()) continue;
    const std::string type(to_text(light.type));
    light.name = type;
    for (int number = 2; !taken.insert(light.name).second; ++number)
      light.name = fmt::format("{}-{}", type, number);
  }
}

std::vector<Light> read_lights(TomlReader& reader) {
  std::vector<Light> lights;
  std::set<std::string> names;
  for (const TomlNode* table : reader.tables("light")) {
    lights.push_back(read_light(*table));
    const std::string& name = lights.back().name;
    if (name.empty() || names.insert(name).second) continue;
    fail_input(fmt::format("two lights are called '{}'", name), table->where,
               "give each a 'name' of its own");
  }
  name_lights(lights, names);
  if (lights.empty()) reader.fail("light", "there is no light", "add a [[light]] table");
  return lights;
}

}  // namespace

Scene parse_scene(std::string_view document, const std::filesystem::path& file, const SceneSearch& search) {
  const TomlNode root = parse_toml(document, file.string());
  TomlReader reader(root, "the scene");
  Scene scene;
  scene.name = file.stem().string();
  scene.title = reader.text("title", scene.name);
  scene.doc = reader.text("doc", "");
  scene.source = {file.string()};
  scene.camera = read_camera(reader.require("camera"));
  scene.lights = read_lights(reader);
  reader.has("mesh");  // a known key
  const TomlNode* motion = reader.find("motion");
  reader.finish();  // unknown keys are reported before large files are read
  const std::vector<const TomlNode*> tables = reader.tables("mesh");
  if (tables.empty()) reader.fail("mesh", "there is no mesh", "add a [[mesh]] table");
  std::vector<NamedMesh> meshes = read_meshes(tables, file.parent_path(), search, scene.warnings);
  for (const NamedMesh& mesh : meshes) {
    if (mesh.animated) scene.animated.push_back(*mesh.animated);
  }
  if (search.at && scene.animated.empty()) fail_not_animated(file, search.at->time_s);
  merge_meshes(meshes, scene);
  if (scene.camera.near_world == 0.0) scene.camera.near_world = derived_near(scene);
  if (motion != nullptr) scene.motion = read_motion(*motion, scene);
  if (auto warning = rounding_warning(scene)) scene.warnings.push_back(std::move(*warning));
  for (std::string& warning : narrow_light_warnings(scene)) scene.warnings.push_back(std::move(warning));
  for (std::string& warning : find_enclosed_lights(scene)) scene.warnings.push_back(std::move(warning));
  scene.hash = hash_scene(scene);
  return scene;
}

Scene seen_from(Scene scene, const Camera& camera) {
  scene.camera = camera;
  if (scene.camera.near_world == 0.0) scene.camera.near_world = derived_near(scene);
  scene.hash = hash_scene(scene);
  return scene;
}

Scene load_scene(const std::filesystem::path& file, const SceneSearch& search) {
  if (!is_importable(file.string())) return parse_scene(read_file(file), file, search);
  const ImportedScene imported = import_file(file, search.at);
  SceneSearch own = search;
  own.at.reset();  // the text has it
  Scene scene = parse_scene(imported.toml, file, own);
  scene.warnings.insert(scene.warnings.begin(), imported.warnings.begin(), imported.warnings.end());
  return scene;
}

}  // namespace umbrameter
