// SPDX-License-Identifier: Apache-2.0
#include "lab/scene_cache.h"

#include "core/files.h"
#include "core/hash.h"
#include "results/json/json_parts.h"
#include "scenes/scene_files.h"
#include "store/code_hashes.h"
#include "store/file_stamp.h"

#include <nlohmann/json.hpp>

#include <algorithm>

namespace umbrameter {
namespace {

using Json = nlohmann::json;

/// Of the file's views under `search.light`; absent where load_scene() will complain.
std::optional<std::string> key_of(const std::filesystem::path& file, const SceneSearch& search) {
  const auto meshes = mesh_files(file, search);
  if (!meshes) return std::nullopt;
  Hasher hasher;
  hasher.text("scenes").text(kReferenceCodeHash).text(search.light).text(file.string()).text(read_file(file));
  if (search.at) hasher.text("at").number(search.at->time_s).text(search.at->animation);
  for (const std::filesystem::path& mesh : *meshes) hasher.text(mesh.string()).text(file_stamp(mesh));
  return hasher.hex();
}

/// Pairs of name and stamp.
Json stamps_of(const std::vector<std::filesystem::path>& files) {
  Json stamps = Json::array();
  for (const std::filesystem::path& file : files) stamps.push_back({file.string(), file_stamp(file)});
  return stamps;
}

Json json_of(const SceneSource& source) {
  const SceneResult& scene = source.description;
  return {{"name", scene.name},
          {"title", scene.title},
          {"doc", scene.doc},
          {"hash", scene.hash},
          {"light_name", scene.light_name},
          {"light_type", scene.light_type},
          {"active_light", source.active_light},
          {"animated", animated_json(scene.animated)},
          {"triangles", scene.triangles},
          {"warnings", scene.warnings},
          {"side_files", stamps_of(source.side_files)}};
}

/// Whether the files are as they were.
bool is_current(const Json& side_files) {
  return std::all_of(side_files.begin(), side_files.end(), [](const Json& file) {
    return file_stamp(file[0].get<std::string>()) == file[1].get<std::string>();
  });
}

LightType light_of(const std::string& text) {
  for (const LightType type : {LightType::rect, LightType::disk, LightType::sphere}) {
    if (to_text(type) == text) return type;
  }
  return LightType::sun;
}

SceneSource read_source(const Json& json) {
  SceneSource source;
  SceneResult& scene = source.description;
  scene.name = json.at("name");
  scene.title = json.at("title");
  scene.doc = json.at("doc");
  scene.hash = json.at("hash");
  scene.light_name = json.at("light_name");
  scene.light_type = json.at("light_type");
  scene.animated = read_animated(json.at("animated"));
  scene.triangles = json.at("triangles");
  scene.warnings = json.at("warnings").get<std::vector<std::string>>();
  source.active_light = json.at("active_light");
  for (const Json& file : json.at("side_files")) source.side_files.emplace_back(file[0].get<std::string>());
  source.light = light_of(scene.light_type);
  return source;
}

/// Views whose scene is loaded only when it is asked for; none when a file they depend on has changed.
std::vector<SceneSource> read_sources(const std::string& text, const std::string& name_or_path,
                                      const SceneSearch& search) {
  std::vector<SceneSource> sources;
  for (const Json& json : Json::parse(text)) {
    if (!is_current(json.at("side_files"))) return {};
    SceneSource source = read_source(json);
    SceneSearch search_one = search;
    search_one.light = source.description.light_name;
    source.load = [name_or_path, search_one] {
      return std::make_shared<const Scene>(load_scene_job(name_or_path, search_one).scene);
    };
    sources.push_back(std::move(source));
  }
  return sources;
}

}  // namespace

std::vector<SceneSource> open_scene(LazyStore& store, const std::string& name_or_path,
                                    const SceneSearch& search) {
  const auto key = key_of(resolve_scene(name_or_path, search), search);
  std::vector<SceneSource> sources;
  if (const auto known = key ? store.find(*key) : std::nullopt)
    sources = read_sources(*known, name_or_path, search);
  if (!sources.empty()) return sources;
  for (SceneJob& view : load_scene_jobs(name_or_path, search)) {
    const auto job = std::make_shared<const SceneJob>(std::move(view));
    SceneSource source = source_of(*job);
    source.load = [job] { return std::shared_ptr<const Scene>(job, &job->scene); };
    sources.push_back(std::move(source));
  }
  return sources;
}

void keep_scene(LazyStore& store, const std::string& name_or_path, const SceneSearch& search,
                std::span<const SceneSource> sources) {
  const auto key = key_of(resolve_scene(name_or_path, search), search);
  if (!key) return;
  Json all = Json::array();
  for (const SceneSource& source : sources) all.push_back(json_of(source));
  const std::string text = all.dump();
  if (store.find(*key) != text) store.store().put({*key, EntryKind::scene, text});
}

}  // namespace umbrameter
