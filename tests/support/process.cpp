// SPDX-License-Identifier: Apache-2.0
#include "tests/support/process.h"

#include "tests/support/temporary_folder.h"

#include <chrono>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <thread>

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

namespace umbrameter {
namespace {

using Clock = std::chrono::steady_clock;

std::string text_of(const std::filesystem::path& file) {
  std::ostringstream text;
  text << std::ifstream(file, std::ios::binary).rdbuf();
  return text.str();
}

[[noreturn]] void become(std::vector<char*> arguments, const ProcessOptions& options,
                         const std::filesystem::path& out, const std::filesystem::path& err) {
  if (!options.working_folder.empty() && chdir(options.working_folder.c_str()) != 0) _exit(125);
  for (const auto& [name, value] : options.environment) {
    if (value.empty()) {
      unsetenv(name.c_str());
    } else {
      setenv(name.c_str(), value.c_str(), 1);
    }
  }
  dup2(open("/dev/null", O_RDONLY), STDIN_FILENO);
  dup2(open(out.c_str(), O_WRONLY | O_CREAT, 0600), STDOUT_FILENO);
  dup2(open(err.c_str(), O_WRONLY | O_CREAT, 0600), STDERR_FILENO);
  execvp(arguments[0], arguments.data());
  _exit(127);
}

int wait_for(pid_t child, const ProcessOptions& options) {
  const auto start = Clock::now();
  bool is_signalled = options.signal == 0;
  int status = 0;
  while (waitpid(child, &status, WNOHANG) == 0) {
    const auto elapsed = Clock::now() - start;
    if (!is_signalled && elapsed >= std::chrono::milliseconds(options.signal_after_ms)) {
      kill(child, options.signal);
      is_signalled = true;
    }
    if (elapsed > std::chrono::seconds(options.timeout_s)) kill(child, SIGKILL);
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

}  // namespace

ProcessResult run_process(const std::vector<std::string>& arguments, const ProcessOptions& options) {
  const TemporaryFolder folder;
  const auto out = folder.path() / "out";
  const auto err = folder.path() / "err";
  std::vector<std::string> copies = arguments;
  std::vector<char*> pointers;
  for (std::string& argument : copies) pointers.push_back(argument.data());
  pointers.push_back(nullptr);
  const pid_t child = fork();
  if (child == 0) become(pointers, options, out, err);
  const int exit_code = wait_for(child, options);
  return {exit_code, text_of(out), text_of(err)};
}

}  // namespace umbrameter
