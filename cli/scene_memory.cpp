// SPDX-License-Identifier: Apache-2.0
#include "cli/scene_memory.h"

#include "core/files.h"
#include "core/hash.h"
#include "scenes/scene_files.h"
#include "study/store/code_hashes.h"
#include "study/store/file_stamp.h"

#include <nlohmann/json.hpp>

namespace umbrameter {
namespace {

using Json = nlohmann::json;

/// Absent where load_scene() will complain.
std::optional<std::string> key_of(const std::filesystem::path& file, const SceneSearch& search) {
  const auto meshes = mesh_files(file, search);
  if (!meshes) return std::nullopt;
  Hasher hasher;
  hasher.text("scene").text(kReferenceCodeHash).text(file.string()).text(read_file(file));
  for (const std::filesystem::path& mesh : *meshes) hasher.text(mesh.string()).text(file_stamp(mesh));
  return hasher.hex();
}

std::string json_of(const SceneSource& source) {
  const SceneResult& scene = source.description;
  return Json{{"title", scene.title},
              {"doc", scene.doc},
              {"hash", scene.hash},
              {"light_name", scene.light_name},
              {"light_type", scene.light_type},
              {"active_light", source.active_light},
              {"triangles", scene.triangles},
              {"warnings", scene.warnings}}
      .dump();
}

LightType light_of(const std::string& text) {
  for (const LightType type : {LightType::rect, LightType::disk, LightType::sphere}) {
    if (to_text(type) == text) return type;
  }
  return LightType::sun;
}

SceneSource read_source(const std::string& text) {
  const Json json = Json::parse(text);
  SceneSource source;
  SceneResult& scene = source.description;
  scene.title = json.at("title");
  scene.doc = json.at("doc");
  scene.hash = json.at("hash");
  scene.light_name = json.at("light_name");
  scene.light_type = json.at("light_type");
  scene.triangles = json.at("triangles");
  scene.warnings = json.at("warnings").get<std::vector<std::string>>();
  source.active_light = json.at("active_light");
  source.light = light_of(scene.light_type);
  return source;
}

}  // namespace

SceneSource open_scene(LateStore& store, const std::string& name_or_path, const SceneSearch& search) {
  const std::filesystem::path file = resolve_scene(name_or_path, search);
  const auto key = key_of(file, search);
  if (const auto known = key ? store.find(*key) : std::nullopt) {
    SceneSource source = read_source(*known);
    source.description.name = scene_name(file, search);
    source.load = [name_or_path, search] {
      return std::make_shared<const Scene>(load_scene_job(name_or_path, search).scene);
    };
    return source;
  }
  const auto job = std::make_shared<const SceneJob>(load_scene_job(name_or_path, search));
  SceneSource source = source_of(*job);
  source.load = [job] { return std::shared_ptr<const Scene>(job, &job->scene); };
  return source;
}

void remember_scene(LateStore& store, const std::string& name_or_path, const SceneSearch& search,
                    const SceneSource& source) {
  const auto key = key_of(resolve_scene(name_or_path, search), search);
  if (key && !store.find(*key)) store.store().put({*key, EntryKind::scene, json_of(source)});
}

}  // namespace umbrameter
