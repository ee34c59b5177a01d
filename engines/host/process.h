// SPDX-License-Identifier: Apache-2.0
#pragma once
// A foreign program with limits: no shell, a process group and a working folder of its own, and never waited for longer
// than said. It dies with this process.

#include "core/clock.h"
#include "core/progress.h"

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <sys/types.h>

namespace umbrameter {

struct ProcessStart {
  std::vector<std::string> arguments;  // the first is the program, searched in PATH
  std::filesystem::path working_folder;
  std::vector<std::pair<std::string, std::string>> environment;  // added to this process's
  uint64_t memory_bytes = 0;  // resident, of the whole process group; 0 = not limited
};

class ForeignProcess {
 public:
  /// Error{environment} when it cannot be started.
  explicit ForeignProcess(const ProcessStart& start);
  /// Ends the whole process group.
  ~ForeignProcess();
  ForeignProcess(const ForeignProcess&) = delete;
  ForeignProcess& operator=(const ForeignProcess&) = delete;

  /// Error{environment} when it takes longer than `limit_s`, when the program has ended or takes too much memory; each
  /// with the program's last words.
  void write_line(const std::string& line, double limit_s, Progress& progress);
  /// One line of its output without the end; errors likewise.
  std::string read_line(double limit_s, Progress& progress);
  /// Waits for the end; the exit code, 128 + signal when one ended it. Errors likewise.
  int wait(double limit_s, Progress& progress);

  /// The end of what it wrote to its error output, on one line; empty when it wrote nothing.
  std::string last_words();
  /// Ends it, with all its children.
  void kill();

 private:
  bool pump(int timeout_ms);
  bool has_ended();
  void check_limits(Clock::time_point deadline, double limit_s, Progress& progress);
  [[noreturn]] void fail(const std::string& problem);
  std::string end_text() const;

  std::string name_;
  uint64_t memory_bytes_;
  pid_t id_ = 0;
  int input_ = -1;  // its standard input, a socket: writing to the dead raises no signal
  int output_ = -1;
  int errors_ = -1;
  std::string unread_;  // of its output
  std::string words_;   // the end of its error output
  std::optional<int> exit_code_;
  Clock::time_point next_memory_check_;
};

}  // namespace umbrameter
