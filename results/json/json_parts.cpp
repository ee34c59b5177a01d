// SPDX-License-Identifier: Apache-2.0
#include "results/json/json_parts.h"

#include "results/json/json_optional.h"

namespace umbrameter {
namespace {

using OrderedJson = nlohmann::ordered_json;

std::string_view kind_text(ErrorKind kind) {
  switch (kind) {
    case ErrorKind::input:
      return "input";
    case ErrorKind::environment:
      return "environment";
    case ErrorKind::cancelled:
      return "cancelled";
    case ErrorKind::internal:
      break;
  }
  return "internal";
}

}  // namespace

OrderedJson interval_json(const std::optional<Interval>& interval) {
  if (!interval) return nullptr;
  return {{"value", interval->value}, {"low", interval->low}, {"high", interval->high}};
}

OrderedJson failure_json(const std::optional<Failure>& failure) {
  if (!failure) return nullptr;
  return {{"kind", kind_text(failure->kind)}, {"message", failure->message}};
}

OrderedJson parameters_json(const ParameterValues& parameters) {
  OrderedJson object = OrderedJson::object();
  for (const auto& [name, value] : parameters) {
    std::visit([&](const auto& held) { object[name] = held; }, value);
  }
  return object;
}

OrderedJson times_json(const std::vector<PassTime>& times) {
  OrderedJson list = OrderedJson::array();
  for (const PassTime& time : times) {
    list.push_back({{"pass", time.pass},
                    {"median_ms", time.median_ms},
                    {"mad_ms", time.mad_ms},
                    {"frames", time.frames}});
  }
  return list;
}

OrderedJson parity_json(const std::optional<ParityNumbers>& parity) {
  if (!parity) return nullptr;
  return {{"passes", parity->passes},
          {"agreement", parity->agreement},
          {"required_agreement", parity->required_agreement},
          {"covered", parity->covered},
          {"coverage_mismatch", parity->coverage_mismatch},
          {"surface_mismatch", parity->surface_mismatch},
          {"irradiance_mismatch", parity->irradiance_mismatch},
          {"same_primitive", parity->same_primitive},
          {"median_relative_depth_error", parity->median_relative_depth_error},
          {"picture_file", parity->picture_file}};
}

OrderedJson animated_json(const std::vector<AnimatedMesh>& meshes) {
  OrderedJson all = OrderedJson::array();
  for (const AnimatedMesh& mesh : meshes)
    all.push_back(
        {{"mesh", mesh.mesh}, {"file", mesh.file}, {"animation", mesh.animation}, {"time_s", mesh.time_s}});
  return all;
}

std::vector<AnimatedMesh> read_animated(const nlohmann::json& json) {
  std::vector<AnimatedMesh> meshes;
  for (const nlohmann::json& mesh : json)
    meshes.push_back({mesh.at("mesh"), mesh.at("file"), mesh.at("animation"), mesh.at("time_s")});
  return meshes;
}

OrderedJson skips_json(const std::vector<Skip>& skipped) {
  OrderedJson list = OrderedJson::array();
  for (const Skip& skip : skipped) {
    list.push_back({{"scene", skip.scene},
                    {"technique", skip.technique},
                    {"reason", skip.reason},
                    {"saved_s", optional_json(skip.saved_s)}});
  }
  return list;
}

std::string dump(const OrderedJson& json) {
  return json.dump(2, ' ', false, OrderedJson::error_handler_t::replace) + "\n";
}

}  // namespace umbrameter
