// SPDX-License-Identifier: Apache-2.0
#include "report/page_data.h"

#include "report/page_texts.h"
#include "report/scene_planes.h"
#include "report/side_data.h"
#include "report/tune_files.h"
#include "results/json/results_json.h"
#include "results/json/run_json.h"
#include "results/pictures/pictures.h"

#include <nlohmann/json.hpp>

namespace umbrameter {
namespace {

using OrderedJson = nlohmann::ordered_json;

OrderedJson palette_json() {
  OrderedJson faults = OrderedJson::array(), parity = OrderedJson::array();
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
  OrderedJson scenes = OrderedJson::array();
  for (const SceneResult& scene : results.scenes) {
    scenes.push_back(add_scene_planes(scene, scenes.size(), folder, store));
  }
  OrderedJson data{
      {"results", OrderedJson::parse(to_json_text(results))},
      {"texts", given ? page_texts(results) : OrderedJson(nullptr)},
      {"scenes", scenes},
      {"bias_sweeps", read_bias_sweeps(beside)},
      {"tunings", read_tunings(beside)},
      {"palette", palette_json()},
      {"metrics", catalogue_json()},
      {"data_folder", store.has_files() ? OrderedJson(store.folder_name()) : OrderedJson(nullptr)}};
  data.update(side_data(beside));
  return script_safe(data.dump(-1, ' ', false, OrderedJson::error_handler_t::replace));
}

}  // namespace umbrameter
