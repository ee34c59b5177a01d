// SPDX-License-Identifier: Apache-2.0
#pragma once
// Runs a program as a user would.

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace umbrameter {

struct ProcessResult {
  int exit_code = -1;  // 128 + signal when a signal ended it
  std::string out;
  std::string err;
};

struct ProcessOptions {
  std::filesystem::path working_folder{};                          // empty = this process's
  std::vector<std::pair<std::string, std::string>> environment{};  // added to this process's; "" unsets
  int timeout_s = 120;                                             // then SIGKILL
  int signal = 0;                                                  // sent after signal_after_ms
  int signal_after_ms = 0;
};

/// Runs `arguments` (the first is the program, searched in PATH) to its end.
ProcessResult run_process(const std::vector<std::string>& arguments, const ProcessOptions& options = {});

}  // namespace umbrameter
