// SPDX-License-Identifier: Apache-2.0
#include "report/tune_files.h"

#include "core/error.h"
#include "report/required_fields.h"
#include "report/side_files.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <string>
#include <vector>

namespace umbrameter {
namespace {

using OrderedJson = nlohmann::ordered_json;

/// A row of numbers as long as `count`; null where nothing could be measured.
OrderedJson row(const OrderedJson& sweep, const char* name, size_t count, const std::string& file) {
  const OrderedJson& numbers = sweep.at(name);
  const bool is_row = numbers.is_array() && std::ranges::all_of(numbers, [](const OrderedJson& number) {
                        return number.is_number() || number.is_null();
                      });
  if (!is_row || numbers.size() != count)
    fail_input(fmt::format("'{}' of bias_sweep is not a row of {} numbers", name, count), {file});
  return numbers;
}

/// In the unit of the bias; null when the search was cut off.
OrderedJson window_json(const OrderedJson& sweep, const std::string& unit) {
  if (!sweep.at("is_complete").get<bool>()) return nullptr;
  if (!sweep.at("has_window").get<bool>()) return {{"empty", true}, {"low", nullptr}, {"high", nullptr}};
  const char* measure = unit == "texels" || unit == "world" ? unit.c_str() : "value";
  return {{"empty", false},
          {"low", sweep.at("acne_free_from").at(measure).get<double>()},
          {"high", sweep.at("peter_pan_free_to").at(measure).get<double>()}};
}

OrderedJson sweep_json(const OrderedJson& sweep, const OrderedJson& document, const std::string& file) {
  const std::string unit = sweep.at("unit").get<std::string>();
  const size_t count = sweep.at("bias").size();
  OrderedJson out{{"file", file},
                  {"parameter", sweep.at("parameter").get<std::string>()},
                  {"unit", unit},
                  {"beside", sweep.contains("beside") ? sweep.at("beside") : OrderedJson("")},
                  {"values", row(sweep, "bias", count, file)},
                  {"objective", row(sweep, "objective", count, file)},
                  {"acne", row(sweep, "acne_share", count, file)},
                  {"peter_panning", row(sweep, "peter_panning_share", count, file)},
                  {"window", window_json(sweep, unit)}};
  if (document.contains("technique")) out["technique"] = document.at("technique").get<std::string>();
  if (document.contains("scenes")) {
    const auto scenes = document.at("scenes").get<std::vector<std::string>>();
    out["scene"] = fmt::format("{}", fmt::join(scenes, ", "));
  }
  return out;
}

constexpr std::array kTuningFields = std::to_array<std::string_view>(
    {"technique:text", "scenes[]:text", "objective:text", "tuned[]:text", "sensitivity[].parameter:text",
     "sensitivity[].rise_below?:number", "sensitivity[].rise_above?:number", "best.name:text",
     "best.same_cost:flag", "best.ratio?:number", "best.held_out_ratio?:number", "best.parameters:object",
     "others[].name:text", "others[].same_cost:flag", "others[].ratio?:number",
     "others[].held_out_ratio?:number", "others[].parameters:object"});

OrderedJson tuning_json(const OrderedJson& document, const std::string& file) {
  require_fields(document, kTuningFields);
  OrderedJson out{{"file", file}};
  for (const char* key : {"technique", "scenes", "objective", "tuned", "sensitivity", "best", "others"})
    out[key] = document.at(key);
  return out;
}

}  // namespace

OrderedJson read_tunings(const std::filesystem::path& folder) {
  OrderedJson tunings = OrderedJson::array();
  for_side_files(folder, kTuneSchema, [&](const OrderedJson& document, const std::string& file) {
    if (document.contains("best")) tunings.push_back(tuning_json(document, file));
  });
  return tunings;
}

OrderedJson read_bias_sweeps(const std::filesystem::path& folder) {
  OrderedJson sweeps = OrderedJson::array();
  for_side_files(folder, kTuneSchema, [&](const OrderedJson& document, const std::string& file) {
    if (!document.contains("bias_sweep")) return;
    const OrderedJson& found = document.at("bias_sweep");
    if (found.is_null()) return;
    const OrderedJson list = found.is_array() ? found : OrderedJson::array({found});
    for (const OrderedJson& sweep : list) sweeps.push_back(sweep_json(sweep, document, file));
  });
  return sweeps;
}

}  // namespace umbrameter
