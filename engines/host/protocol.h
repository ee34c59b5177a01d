// SPDX-License-Identifier: Apache-2.0
#pragma once
// What umbrameter and an adapter write to each other: one JSON object a line (docs/engines.md).

#include "core/renderer.h"

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace umbrameter {

inline constexpr int kEngineProtocol = 1;

/// The first line of an adapter: {"ready": true, "version": "...", "device": "..."}.
struct EngineReady {
  std::string version;  // of the engine, as it says itself
  std::string device;   // what it draws on
  bool is_software = false;
};

struct EngineRequest {
  uint64_t id = 0;
  std::filesystem::path scene;  // folder with scene.obj and scene.json
  std::filesystem::path out;    // folder for the answer's files
  const RenderRequest* request = nullptr;
  int timed_frames = 0;        // of the picture with shadows, if the engine can tell; 0 = no times
  double timed_seconds = 0.0;  // none begins later
};

/// Files by what they show: visibility, lit, unlit, position, normal, surfaces; all are inside the request's `out`.
struct EngineAnswer {
  std::map<std::string, std::filesystem::path> files;
  std::vector<std::string> warnings;
  uint64_t memory_bytes = 0;
  std::vector<double> frame_ms;  // one after another; empty where the engine cannot tell
  std::string timer;             // what measured them
};

/// Error{environment} for a line that says something else.
EngineReady parse_ready(const std::string& line);

std::string request_line(const EngineRequest& request);

/// Error{input} with the adapter's sentence when it answers with an error; Error{environment} for garbage, another
/// request's answer, names that leave `out`, files that are not there, and times that are none.
EngineAnswer parse_answer(const std::string& line, const EngineRequest& request);

}  // namespace umbrameter
