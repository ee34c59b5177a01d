// SPDX-License-Identifier: Apache-2.0
#include "results/json/record.h"

#include "core/version.h"
#include "results/json/json_optional.h"
#include "results/json/json_parts.h"
#include "results/json/run_json.h"

#include <fmt/chrono.h>

#include <chrono>

namespace umbrameter {
namespace {

using OrderedJson = nlohmann::ordered_json;

OrderedJson head_json(const RecordHead& head, const std::string& status) {
  return {{"scene", head.scene},
          {"camera", head.camera},
          {"scene_hash", head.scene_hash},
          {"light", head.light},
          {"width_px", head.picture.width_px},
          {"height_px", head.picture.height_px},
          {"samples_per_pixel", head.picture.samples_per_pixel},
          {"target_se", optional_json(head.picture.target_se)},
          {"seed", head.picture.seed},
          {"status", status},
          {"commit", head.commit},
          {"started", head.started},
          {"duration_s", head.duration_s}};
}

RecordHead read_head(const nlohmann::json& json) {
  RecordHead head;
  head.scene = json.at("scene");
  head.camera = json.at("camera");
  head.scene_hash = json.at("scene_hash");
  head.light = json.at("light");
  head.picture = read_picture_quality(json);
  head.commit = json.at("commit");
  head.started = json.at("started");
  head.duration_s = json.at("duration_s");
  return head;
}

std::string compact(const OrderedJson& json) {
  return json.dump(-1, ' ', false, OrderedJson::error_handler_t::replace);
}

}  // namespace

RecordHead make_head(const std::string& name, const Scene& scene, const PictureQuality& picture) {
  RecordHead head;
  head.scene = name;
  head.scene_hash = scene.hash;
  head.light = to_text(scene.light().type);
  head.picture = picture;
  head.commit = kCommit;
  head.started = time_now();
  return head;
}

std::string status_of(const RunRecord& record) {
  if (record.result.failure) return "failed";
  if (record.result.error && record.result.error->scored_pixels == 0) return "void";
  return record.parity && !record.parity->passes ? "void" : "ok";
}

std::string to_json_text(const RunRecord& record) {
  OrderedJson json = head_json(record.head, status_of(record));
  json["reference"] = record.reference;
  json["baseline"] = record.baseline;
  json["baseline_times"] = times_json(record.baseline_times);
  json["parity"] = parity_json(record.parity);
  json["result"] = technique_json(record.result);
  return compact(json);
}

std::string to_json_text(const ReferenceRecord& record) {
  OrderedJson json = head_json(record.head, "ok");
  json["result"] = reference_json(record.result);
  return compact(json);
}

std::optional<RunRecord> parse_run_record(std::string_view text) {
  try {
    const auto json = nlohmann::json::parse(text);
    return RunRecord{read_head(json),
                     json.at("reference"),
                     json.at("baseline"),
                     read_times(json.at("baseline_times")),
                     read_parity(json.at("parity")),
                     read_technique(json.at("result")),
                     {}};
  } catch (const nlohmann::json::exception&) {
    return std::nullopt;
  }
}

std::optional<ReferenceRecord> parse_reference_record(std::string_view text) {
  try {
    const auto json = nlohmann::json::parse(text);
    const auto result = read_reference(json.at("result"));
    if (!result) return std::nullopt;
    return ReferenceRecord{read_head(json), *result};
  } catch (const nlohmann::json::exception&) {
    return std::nullopt;
  }
}

std::string time_now() {
  const auto now = std::chrono::time_point_cast<std::chrono::milliseconds>(std::chrono::system_clock::now());
  const auto second = std::chrono::time_point_cast<std::chrono::seconds>(now);
  return fmt::format("{:%Y-%m-%dT%H:%M:%S}.{:03}Z", fmt::gmtime(std::chrono::system_clock::to_time_t(second)),
                     (now - second).count());
}

}  // namespace umbrameter
