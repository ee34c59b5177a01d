// SPDX-License-Identifier: Apache-2.0
#pragma once
// Another program, run to its end without a shell.

#include <filesystem>
#include <string>
#include <vector>

namespace umbrameter {

struct ProgramEnd {
  int exit_code = 0;     // 128 + signal when one ended it
  std::string messages;  // what it wrote to standard output and error
};

/// `arguments[0]` is looked up in PATH; its input is empty. `messages_file` takes what it writes and stays.
/// Error{environment} when it cannot be started.
ProgramEnd run_program(std::vector<std::string> arguments, const std::filesystem::path& messages_file);

}  // namespace umbrameter
