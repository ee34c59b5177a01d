// SPDX-License-Identifier: Apache-2.0
#include "cli/exact_program.h"

#include "cli/staging.h"
#include "core/data_folder.h"
#include "reference/exact_request.h"

#include <fmt/format.h>

#include <cstdio>
#include <cstring>
#include <fstream>
#include <memory>

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

extern char** environ;

namespace umbrameter {
namespace {

namespace fs = std::filesystem;

constexpr const char* kName = "umbrameter-exact";

/// The program at work; `next_line` until nothing comes, then `wait`.
class Answers {
 public:
  Answers(const fs::path& program, const fs::path& request, const fs::path& messages) {
    std::string path = program.string(), argument = request.string();
    char* arguments[] = {path.data(), argument.data(), nullptr};
    int ends[2];
    if (pipe2(ends, O_CLOEXEC) != 0) fail_environment(fmt::format("no pipe: {}", std::strerror(errno)));
    posix_spawn_file_actions_t files;
    posix_spawn_file_actions_init(&files);
    posix_spawn_file_actions_addopen(&files, 0, "/dev/null", O_RDONLY, 0);
    posix_spawn_file_actions_adddup2(&files, ends[1], 1);
    posix_spawn_file_actions_addopen(&files, 2, messages.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
    const int problem = posix_spawn(&id_, path.c_str(), &files, nullptr, arguments, environ);
    posix_spawn_file_actions_destroy(&files);
    close(ends[1]);
    stream_.reset(fdopen(ends[0], "r"));
    if (problem != 0)
      fail_environment(fmt::format("'{}' cannot be started: {}", path, std::strerror(problem)));
  }
  ~Answers() {
    if (id_ == 0) return;
    kill(id_, SIGKILL);
    wait();
  }
  Answers(const Answers&) = delete;
  Answers& operator=(const Answers&) = delete;

  bool next_line(std::string& line) {
    char text[512];
    if (std::fgets(text, sizeof text, stream_.get()) == nullptr) return false;
    line = text;
    if (!line.empty() && line.back() == '\n') line.pop_back();
    return true;
  }
  /// The exit code; 128 + signal when one ended it.
  int wait() {
    int status = 0;
    while (waitpid(id_, &status, 0) < 0 && errno == EINTR) {
    }
    id_ = 0;
    return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  }

 private:
  struct Closer {
    void operator()(FILE* file) const { std::fclose(file); }
  };
  pid_t id_ = 0;
  std::unique_ptr<FILE, Closer> stream_;
};

std::string first_line_of(const fs::path& file) {
  std::ifstream stream(file);
  std::string line;
  std::getline(stream, line);
  return line;
}

std::vector<ExactLight> ask(const fs::path& program, const Scene& scene,
                            std::span<const ExactReceiver> receivers, int threads, Progress& progress) {
  const Staging staging(fs::temp_directory_path());
  const fs::path request = staging.folder() / "request", messages = staging.folder() / "messages";
  write_exact_request(request, scene, receivers, threads);
  progress.begin("exact check", receivers.size());
  std::vector<std::optional<ExactLight>> answers(receivers.size());
  Answers program_answers(program, request, messages);
  size_t given = 0;
  std::string line;
  while (program_answers.next_line(line)) {
    const auto [receiver, answer] = from_line(line);
    if (receiver >= answers.size() || answers[receiver])
      fail_environment(fmt::format("{} answers for a point that was not asked: '{}'", kName, line));
    answers[receiver] = answer;
    ++given;
    progress.advance(1);
  }
  const int code = program_answers.wait();
  progress.end();
  if (code != 0 || given != answers.size()) {
    fail_environment(fmt::format("{} ended with {} after {} of {} points: {}", program.string(), code, given,
                                 answers.size(), first_line_of(messages)));
  }
  std::vector<ExactLight> all;
  for (const auto& answer : answers) all.push_back(*answer);
  return all;
}

}  // namespace

std::optional<fs::path> find_exact_program() {
  const fs::path program = program_file().parent_path() / kName;
  return access(program.c_str(), X_OK) == 0 ? std::optional(program) : std::nullopt;
}

ExactOracle exact_oracle_of(const fs::path& program) {
  return [program](const Scene& scene, std::span<const ExactReceiver> receivers, int threads,
                   Progress& progress) { return ask(program, scene, receivers, threads, progress); };
}

ExactOracle require_exact_oracle() {
  const auto program = find_exact_program();
  if (!program) {
    fail_environment(fmt::format("'{}' is not there", (program_file().parent_path() / kName).string()),
                     "the package umbrameter-exact has it, or build the target of that name");
  }
  return exact_oracle_of(*program);
}

}  // namespace umbrameter
