#include "report/tune_files.h"

#include "core/error.h"
#include "core/files.h"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <vector>

namespace umbrameter {
namespace {

using Json = nlohmann::ordered_json;

std::vector<std::filesystem::path> tune_files(const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    const std::string name = entry.path().filename().string();
    if (entry.is_regular_file() && name.starts_with("tune") && name.ends_with(".json"))
      files.push_back(entry.path());
  }
  std::ranges::sort(files);
  return files;
}

Json sweep_json(const Json& sweep, const Json& document, const std::string& file) {
  Json out{{"file", file},
           {"parameter", sweep.at("parameter").get<std::string>()},
           {"unit", sweep.at("unit").get<std::string>()}};
  const size_t count = sweep.at("values").size();
  for (const char* name : {"values", "objective", "acne", "peter_panning"}) {
    const auto numbers = sweep.at(name).get<std::vector<double>>();
    if (numbers.size() != count) {
      fail_input(fmt::format("'{}' of bias_sweep has {} numbers for {} values", name, numbers.size(), count),
                 {file});
    }
    out[name] = numbers;
  }
  const Json& window = sweep.at("window");
  const bool is_empty = window.at("empty").get<bool>();
  out["window"] = {{"empty", is_empty},
                   {"low", is_empty ? Json(nullptr) : Json(window.at("low").get<double>())},
                   {"high", is_empty ? Json(nullptr) : Json(window.at("high").get<double>())}};
  for (const char* name : {"scene", "technique"}) {
    const Json& owner = sweep.contains(name) ? sweep : document;
    if (owner.contains(name) && owner.at(name).is_string()) out[name] = owner.at(name);
  }
  return out;
}

}  // namespace

Json read_bias_sweeps(const std::filesystem::path& folder) {
  Json sweeps = Json::array();
  for (const std::filesystem::path& path : tune_files(folder)) {
    try {
      const Json document = Json::parse(read_file(path));
      if (!document.contains("bias_sweep")) continue;
      const Json& found = document.at("bias_sweep");
      if (found.is_null()) continue;
      const Json list = found.is_array() ? found : Json::array({found});
      for (const Json& sweep : list) sweeps.push_back(sweep_json(sweep, document, path.filename().string()));
    } catch (const nlohmann::json::exception& error) {  // a foreign exception becomes ours here
      fail_input(fmt::format("not a tuning result: {}", error.what()), {path.string()},
                 "make it again with 'umbrameter tune', or move it elsewhere");
    }
  }
  return sweeps;
}

}  // namespace umbrameter
