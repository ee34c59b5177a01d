// SPDX-License-Identifier: Apache-2.0
#include "report/page_data.h"

#include "report/page_texts.h"
#include "report/scene_planes.h"
#include "report/side_data.h"
#include "report/tune_files.h"
#include "study/pictures.h"
#include "study/results_json.h"

#include <nlohmann/json.hpp>

namespace umbrameter {
namespace {

using Json = nlohmann::ordered_json;

Json palette_json() {
  Json faults = Json::array(), parity = Json::array();
  for (const FaultLegend& entry : fault_legend()) {
    faults.push_back({{"name", name_of(entry.fault)}, {"colour", entry.colour}, {"text", entry.text}});
  }
  for (const ParityLegend& entry : parity_legend()) {
    parity.push_back({{"colour", entry.colour}, {"text", entry.text}});
  }
  return {{"error_scale", kSignedErrorScale},
          {"too_dark", kTooDarkColour},
          {"no_error", kNoErrorColour},
          {"too_bright", kTooBrightColour},
          {"background", kBackgroundColour},
          {"unscored", kUnscoredColour},
          {"faults", faults},
          {"parity", parity}};
}

}  // namespace

std::string script_safe(std::string json) {
  for (size_t at = json.find('<'); at != std::string::npos; at = json.find('<', at)) {
    json.replace(at, 1, "\\u003c");
  }
  return json;
}

std::string page_data(const std::optional<Results>& given, const std::filesystem::path& folder,
                      const std::filesystem::path& beside, PlaneStore& store) {
  const Results results = given.value_or(Results());
  Json scenes = Json::array();
  for (const SceneResult& scene : results.scenes) {
    scenes.push_back(add_scene_planes(scene, scenes.size(), folder, store));
  }
  Json data{{"results", Json::parse(to_json_text(results))},
            {"texts", given ? page_texts(results) : Json(nullptr)},
            {"scenes", scenes},
            {"bias_sweeps", read_bias_sweeps(beside)},
            {"tunings", read_tunings(beside)},
            {"palette", palette_json()},
            {"data_folder", store.has_files() ? Json(store.folder_name()) : Json(nullptr)}};
  data.update(side_data(beside));
  return script_safe(data.dump(-1, ' ', false, Json::error_handler_t::replace));
}

}  // namespace umbrameter
