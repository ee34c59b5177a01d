// SPDX-License-Identifier: Apache-2.0
#include "engines/host/protocol.h"

#include "core/error.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <array>

namespace umbrameter {
namespace {

using Json = nlohmann::json;
namespace fs = std::filesystem;

constexpr size_t kShown = 200;  // of garbage, in a message
constexpr std::array<const char*, 6> kPictures = {"visibility", "lit",    "unlit",
                                                  "position",   "normal", "surfaces"};

/// Printable and short.
std::string shown(const std::string& line) {
  std::string text;
  for (const char c : line.substr(0, kShown)) text += c >= ' ' && c < 0x7f ? c : '?';
  return line.size() > kShown ? text + "..." : text;
}

[[noreturn]] void fail_garbage(const std::string& line, const std::string& wanted) {
  fail_environment(fmt::format("the adapter wrote '{}', not {}", shown(line), wanted));
}

Json parse_object(const std::string& line, const std::string& wanted) {
  Json json = Json::parse(line, nullptr, false);
  if (!json.is_object()) fail_garbage(line, wanted);
  return json;
}

std::string text_of(const Json& json, const char* key) {
  const auto found = json.find(key);
  return found != json.end() && found->is_string() ? found->get<std::string>() : "";
}

Json value_json(const ParameterValue& value) {
  return std::visit([](const auto& held) { return Json(held); }, value);
}

/// A plain name, and what it names lies in `folder` for good: no link leads out.
fs::path file_in(const fs::path& folder, const Json& name, const std::string& line) {
  if (!name.is_string()) fail_garbage(line, "names of files");
  const fs::path file = name.get<std::string>();
  const bool is_plain = file.has_filename() && file == file.filename() && file != "." && file != "..";
  if (!is_plain)
    fail_environment(
        fmt::format("the adapter names the file '{}', which is no plain name", shown(file.string())));
  std::error_code ignored;
  if (!fs::exists(folder / file, ignored))
    fail_environment(fmt::format("the adapter names the file '{}', which it did not write", file.string()));
  if (fs::is_symlink(folder / file) || !fs::is_regular_file(folder / file))
    fail_environment(fmt::format("what the adapter wrote as '{}' is no plain file", file.string()));
  return folder / file;
}

std::vector<double> times_of(const Json& times, const std::string& line) {
  if (!times.is_array()) fail_garbage(line, "times of frames");
  std::vector<double> frame_ms;
  for (const Json& time : times) {
    if (!time.is_number() || !(time.get<double>() >= 0.0)) fail_garbage(line, "times of frames");
    frame_ms.push_back(time.get<double>());
  }
  return frame_ms;
}

}  // namespace

EngineReady parse_ready(const std::string& line) {
  const std::string wanted = R"({"ready": true, "version": "...", "device": "..."})";
  const Json json = parse_object(line, wanted);
  if (const std::string problem = text_of(json, "error"); !problem.empty()) fail_environment(problem);
  if (json.value("ready", Json()) != Json(true)) fail_garbage(line, wanted);
  return {text_of(json, "version"), text_of(json, "device"), json.value("is_software", Json()) == Json(true)};
}

std::string request_line(const EngineRequest& request) {
  const RenderRequest& wanted = *request.request;
  Json parameters = Json::object();
  for (const auto& [name, value] : wanted.parameters) parameters[name] = value_json(value);
  Json json = {{"protocol", kEngineProtocol},
               {"id", request.id},
               {"scene", request.scene.string()},
               {"out", request.out.string()},
               {"width_px", wanted.width_px},
               {"height_px", wanted.height_px},
               {"seed", wanted.seed},
               {"parameters", parameters}};
  if (request.timed_frames > 0) {
    json["timed_frames"] = request.timed_frames;
    json["timed_seconds"] = request.timed_seconds;
  }
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

EngineAnswer parse_answer(const std::string& line, const EngineRequest& request) {
  const Json json = parse_object(line, "an answer");
  if (json.value("id", Json()) != Json(request.id))
    fail_garbage(line, fmt::format("the answer to request {}", request.id));
  if (json.contains("error")) {
    const std::string problem = text_of(json, "error");
    fail_input(problem.empty() ? "the adapter failed without a word" : problem);
  }
  EngineAnswer answer;
  for (const char* picture : kPictures) {
    if (const auto name = json.find(picture); name != json.end())
      answer.files[picture] = file_in(request.out, *name, line);
  }
  if (const auto warnings = json.find("warnings"); warnings != json.end() && warnings->is_array()) {
    for (const Json& warning : *warnings) {
      if (warning.is_string()) answer.warnings.push_back(warning.get<std::string>());
    }
  }
  if (const auto memory = json.find("memory_bytes"); memory != json.end() && memory->is_number_unsigned())
    answer.memory_bytes = memory->get<uint64_t>();
  if (const auto times = json.find("frame_ms"); times != json.end() && !times->is_null())
    answer.frame_ms = times_of(*times, line);
  answer.timer = text_of(json, "timer");
  return answer;
}

}  // namespace umbrameter
