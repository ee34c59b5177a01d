// SPDX-License-Identifier: Apache-2.0
#pragma once
// This program again, in a process of its own.

#include <filesystem>
#include <string>
#include <vector>

#include <sys/types.h>

namespace umbrameter {

/// Runs until it ends or this dies, whichever comes first.
class ChildProcess {
 public:
  /// `arguments` after the program's name. Its output goes nowhere, its messages to `log`.
  ChildProcess(const std::vector<std::string>& arguments, const std::filesystem::path& log);
  ~ChildProcess();
  ChildProcess(const ChildProcess&) = delete;
  ChildProcess& operator=(const ChildProcess&) = delete;

  bool has_ended();
  void kill();
  /// After its end: 128 + signal when one ended it.
  int exit_code() const { return exit_code_; }

 private:
  pid_t id_ = 0;
  bool has_ended_ = false;
  int exit_code_ = 0;
};

/// Called by the child: it dies with its parent, however that ends.
void die_with_parent();

}  // namespace umbrameter
