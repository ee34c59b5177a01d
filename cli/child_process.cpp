// SPDX-License-Identifier: Apache-2.0
#include "cli/child_process.h"

#include "core/error.h"

#include <fmt/format.h>

#include <csignal>
#include <cstring>

#include <fcntl.h>
#include <spawn.h>
#include <sys/prctl.h>
#include <sys/wait.h>

extern char** environ;

namespace umbrameter {

ChildProcess::ChildProcess(const std::vector<std::string>& arguments, const std::filesystem::path& log) {
  std::vector<std::string> texts = {"umbrameter"};
  texts.insert(texts.end(), arguments.begin(), arguments.end());
  std::vector<char*> pointers;
  for (std::string& text : texts) pointers.push_back(text.data());
  pointers.push_back(nullptr);
  posix_spawn_file_actions_t files;
  posix_spawn_file_actions_init(&files);
  posix_spawn_file_actions_addopen(&files, 0, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_addopen(&files, 1, "/dev/null", O_WRONLY, 0);
  posix_spawn_file_actions_addopen(&files, 2, log.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
  const int problem = posix_spawn(&id_, "/proc/self/exe", &files, nullptr, pointers.data(), environ);
  posix_spawn_file_actions_destroy(&files);
  if (problem != 0) fail_environment(fmt::format("no process can be started: {}", std::strerror(problem)));
}

ChildProcess::~ChildProcess() {
  if (!has_ended_) kill();
}

bool ChildProcess::has_ended() {
  int status = 0;
  if (has_ended_ || waitpid(id_, &status, WNOHANG) != id_) return has_ended_;
  exit_code_ = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  has_ended_ = true;
  return true;
}

void ChildProcess::kill() {
  if (has_ended_) return;
  ::kill(id_, SIGKILL);
  int status = 0;
  waitpid(id_, &status, 0);
  exit_code_ = 128 + SIGKILL;
  has_ended_ = true;
}

void die_with_parent() {
  prctl(PR_SET_PDEATHSIG, SIGKILL);
}

}  // namespace umbrameter
