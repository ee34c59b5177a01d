// SPDX-License-Identifier: Apache-2.0
#include "lab/stored_frames.h"

#include "core/hash.h"
#include "core/image_io.h"
#include "lab/stored_truth.h"
#include "results/json/json_optional.h"
#include "results/json/json_parts.h"
#include "results/json/run_json.h"
#include "scenes/scene_hash.h"

#include <nlohmann/json.hpp>

#include <vector>

namespace umbrameter {
namespace {

using OrderedJson = nlohmann::ordered_json;

constexpr const char* kSurfaces = "surfaces";

/// Where a plane stands: those of the surfaces in one file, each other one in its own, so that pictures share what is the same.
std::string group_of(const std::string& plane) {
  for (const std::string_view start : {"position.", "normal.", "shading_normal."})
    if (plane.starts_with(start)) return kSurfaces;
  return plane == "primitive_id" || plane == "unshadowed_irradiance" ? kSurfaces : plane;
}

std::map<std::string, Image> parts_of(const Image& image) {
  std::map<std::string, Image> parts;
  for (const auto& [name, values] : image.planes) {
    Image& part = parts.try_emplace(group_of(name), image.width, image.height).first->second;
    part.planes[name] = values;
  }
  return parts;
}

std::string hash_of(const Image& image) {
  Hasher hasher;
  hasher.number(image.width).number(image.height);
  for (const auto& [name, values] : image.planes)
    hasher.text(name).bytes(values.data(), values.size() * sizeof(float));
  return hasher.hex();
}

OrderedJson frame_json(const Frame& frame) {
  return {{"parameters", parameters_json(frame.parameters)},
          {"device", frame.device},
          {"is_software", frame.is_software},
          {"memory_bytes", frame.memory_bytes},
          {"wall_time_s", frame.wall_time_s},
          {"warnings", frame.warnings},
          {"left_out", frame.left_out},
          {"frames_before", frame.frames_before},
          {"motion", frame.motion},
          {"metadata", frame.image.metadata}};
}

Frame read_frame(const nlohmann::json& json) {
  Frame frame;
  frame.parameters = read_parameters(json.at("parameters"));
  frame.device = json.at("device");
  frame.is_software = json.at("is_software");
  frame.memory_bytes = json.at("memory_bytes");
  frame.wall_time_s = json.at("wall_time_s");
  frame.warnings = json.at("warnings");
  frame.left_out = json.at("left_out");
  frame.frames_before = json.at("frames_before");
  frame.motion = json.at("motion");
  frame.image.metadata = json.at("metadata");
  return frame;
}

}  // namespace

void keep_frame(Store& store, const std::string& key, const Frame& frame,
                std::span<const std::string> objects) {
  OrderedJson json = frame_json(frame);
  json["images"] = objects;
  store.put({key, EntryKind::frame, json.dump()});
}

std::string StoredFrames::key_of(const Scene& scene, const RenderRequest& request) {
  if (request.blocker_truth != nullptr) return {};
  std::string& hash = hashes_[request.technique];
  if (hash.empty() && !request.technique.empty()) hash = hash_of_(request.technique);
  return frame_key(hash_scene(scene), scene.active_light, request, hash, makers_);
}

const Image& StoredFrames::part(const std::string& object, Image& made) {
  if (last_object_ == object) return last_surfaces_;
  made = read_image(store_.store().path_of(object));
  if (!made.has("primitive_id")) return made;
  last_object_ = object;
  return last_surfaces_ = std::move(made);
}

void StoredFrames::add_part(const std::string& object, Image& image) {
  Image made;
  const Image& found = part(object, made);
  image.width = found.width;
  image.height = found.height;
  image.metadata.insert(found.metadata.begin(), found.metadata.end());
  image.planes.insert(found.planes.begin(), found.planes.end());
}

std::optional<Frame> StoredFrames::find(const std::string& key) {
  if (key.empty() || !use_.find) return std::nullopt;
  return read_json(store_.find(key), [&](const nlohmann::json& json) {
    Frame frame = read_frame(json);
    for (const nlohmann::json& object : json.at("images")) add_part(object, frame.image);
    frame.image.planes.erase("scored");  // a score's, which a kept picture has beside its own
    return std::optional(std::move(frame));
  });
}

void StoredFrames::keep(const std::string& key, const RenderRequest& request, const Frame& frame) {
  if (key.empty() || !keeps(request)) return;
  std::vector<std::string> objects;
  for (const auto& [group, part] : parts_of(frame.image)) {
    std::string& object = kept_[hash_of(part)];
    if (object.empty()) object = keep_image(store_.store(), part, scratch_);
    objects.push_back(object);
  }
  keep_frame(store_.store(), key, frame, objects);
}

Frame StoredFrames::render(const Scene& scene, const RenderRequest& request, Progress& progress) {
  const std::string key = key_of(scene, request);
  if (auto known = find(key)) {
    ++reused_;
    return *std::move(known);
  }
  Frame frame = renderer_.render(scene, request, progress);
  keep(key, request, frame);
  return frame;
}

PreparedRun StoredFrames::prepare(const Scene& scene, const RenderRequest& request, Progress& progress) {
  PreparedRun run = renderer_.prepare(scene, request, progress);
  if (!keeps(request)) return run;
  const std::string key = key_of(scene, request);
  if (!store_.find(key)) keep(key, request, run.frame);
  return run;
}

}  // namespace umbrameter
