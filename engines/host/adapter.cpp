// SPDX-License-Identifier: Apache-2.0
#include "engines/host/adapter.h"

#include "core/error.h"

#include <fmt/format.h>

namespace umbrameter {

ProcessStart start_of(const Engine& engine, std::vector<std::string> arguments,
                      const std::filesystem::path& work_folder) {
  const std::string folder = work_folder.string();
  return {.arguments = std::move(arguments),
          .working_folder = work_folder,
          .environment = {{"TMPDIR", folder},
                          {"UMBRAMETER_ENGINE_FOLDER", engine.folder.string()},
                          {"PYTHONDONTWRITEBYTECODE", "1"}},
          .memory_bytes = engine.limits.memory_bytes};
}

Adapter::Adapter(const Engine& engine, const std::filesystem::path& work_folder, Progress& progress)
    : limits_(engine.limits), process_(start_of(engine, engine.command, work_folder)) {
  ready_ = parse_ready(process_.read_line(limits_.start_s, progress));
}

EngineAnswer Adapter::ask(const EngineRequest& request, Progress& progress) {
  process_.write_line(request_line(request), limits_.picture_s, progress);
  const std::string line = process_.read_line(limits_.picture_s, progress);
  try {
    return parse_answer(line, request);
  } catch (const Error& error) {
    const std::string words = error.kind() == ErrorKind::input ? "" : process_.last_words();
    if (words.empty()) throw;
    fail_environment(fmt::format("{}; its last words: {}", error.what(), words));
  }
}

}  // namespace umbrameter
