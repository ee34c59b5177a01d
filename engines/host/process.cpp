// SPDX-License-Identifier: Apache-2.0
#include "engines/host/process.h"

#include "core/error.h"
#include "engines/host/process_memory.h"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>

#include <fcntl.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

extern char** environ;

namespace umbrameter {
namespace {

constexpr int kTick_ms = 50;
constexpr size_t kLongestLine = size_t{1} << 20;
constexpr size_t kMostWords = 600;
constexpr auto kMemoryInterval = std::chrono::milliseconds(250);
constexpr rlim_t kLargestFile = rlim_t{4} << 30;

/// Both ends of a pipe, closed in whatever is started.
struct Pipe {
  int read = -1, write = -1;
};

Pipe make_pipe() {
  int ends[2];
  if (pipe2(ends, O_CLOEXEC) != 0)
    fail_environment(fmt::format("no pipe can be made: {}", std::strerror(errno)));
  return {ends[0], ends[1]};
}

std::vector<char*> pointers_of(std::vector<std::string>& texts) {
  std::vector<char*> pointers;
  for (std::string& text : texts) pointers.push_back(text.data());
  pointers.push_back(nullptr);
  return pointers;
}

std::vector<std::string> environment_of(const ProcessStart& start) {
  std::vector<std::string> texts;
  for (char** entry = environ; *entry != nullptr; ++entry) {
    const std::string text = *entry;
    const auto is_replaced = [&](const auto& added) { return text.starts_with(added.first + "="); };
    if (std::ranges::none_of(start.environment, is_replaced)) texts.push_back(text);
  }
  for (const auto& [name, value] : start.environment) texts.push_back(name + "=" + value);
  return texts;
}

void set_limit(int resource, rlim_t value) {
  rlimit limit{};
  getrlimit(resource, &limit);
  limit.rlim_cur = std::min(value, limit.rlim_max);
  setrlimit(resource, &limit);
}

/// In the child, where nothing may be allocated; returns when it fails.
void become(int input, int output, int errors, const char* folder, char* const* arguments,
            char* const* environment) {
  setpgid(0, 0);
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  set_limit(RLIMIT_CORE, 0);
  set_limit(RLIMIT_FSIZE, kLargestFile);
  sigset_t none;
  sigemptyset(&none);
  sigprocmask(SIG_SETMASK, &none, nullptr);
  std::signal(SIGPIPE, SIG_DFL);
  if (chdir(folder) != 0 || dup2(input, 0) < 0 || dup2(output, 1) < 0 || dup2(errors, 2) < 0) return;
  close_range(3, ~0U, CLOSE_RANGE_CLOEXEC);
  execvpe(arguments[0], arguments, environment);
}

Clock::time_point deadline_after(double limit_s) {
  return Clock::now() + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(limit_s));
}

void close_end(int& end) {
  if (end >= 0) close(end);
  end = -1;
}

/// All that is there; false at the end of the file.
bool read_all(int end, std::string& text) {
  char buffer[1 << 16];
  while (true) {
    const ssize_t count = read(end, buffer, sizeof buffer);
    if (count > 0) text.append(buffer, static_cast<size_t>(count));
    if (count == 0) return false;
    if (count < 0) return errno == EAGAIN || errno == EINTR;
  }
}

}  // namespace

ForeignProcess::ForeignProcess(const ProcessStart& start)
    : name_(std::filesystem::path(start.arguments.front()).filename().string()),
      memory_bytes_(start.memory_bytes),
      next_memory_check_(Clock::now()) {
  int sockets[2];
  if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, sockets) != 0)
    fail_environment(fmt::format("no socket can be made: {}", std::strerror(errno)));
  Pipe output = make_pipe(), errors = make_pipe(), failure = make_pipe();
  std::vector<std::string> arguments = start.arguments, environment = environment_of(start);
  const std::vector<char*> argument_pointers = pointers_of(arguments),
                           environment_pointers = pointers_of(environment);
  const std::string folder = start.working_folder.string();
  id_ = fork();
  if (id_ == 0) {
    become(sockets[1], output.write, errors.write, folder.c_str(), argument_pointers.data(),
           environment_pointers.data());
    const int problem = errno;
    [[maybe_unused]] const ssize_t written = write(failure.write, &problem, sizeof problem);
    _exit(127);
  }
  input_ = sockets[0];
  output_ = output.read;
  errors_ = errors.read;
  for (int* end : {&sockets[1], &output.write, &errors.write, &failure.write}) close_end(*end);
  int problem = id_ < 0 ? errno : 0;
  if (id_ > 0 && read(failure.read, &problem, sizeof problem) != sizeof problem) problem = 0;
  close_end(failure.read);
  for (const int end : {input_, output_, errors_}) fcntl(end, F_SETFL, O_NONBLOCK);
  if (problem == 0) return;
  if (id_ > 0) kill();
  for (int* end : {&input_, &output_, &errors_}) close_end(*end);
  fail_environment(fmt::format("'{}' cannot be started: {}", start.arguments.front(), std::strerror(problem)),
                   "is it installed, and may it be executed?");
}

ForeignProcess::~ForeignProcess() {
  kill();
  for (int* end : {&input_, &output_, &errors_}) close_end(*end);
}

void ForeignProcess::kill() {
  if (id_ <= 0) return;
  ::kill(-id_, SIGKILL);  // children may outlive their parent
  if (!exit_code_) {
    ::kill(id_, SIGKILL);  // when it has no group of its own yet
    int status = 0;
    waitpid(id_, &status, 0);
    exit_code_ = 128 + SIGKILL;
  }
  id_ = 0;  // another process may get the number
}

bool ForeignProcess::has_ended() {
  int status = 0;
  if (exit_code_) return true;
  if (waitpid(id_, &status, WNOHANG) != id_) return false;
  exit_code_ = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  return true;
}

std::string ForeignProcess::end_text() const {
  const int code = exit_code_.value_or(0);
  return code > 128 ? fmt::format("was ended by signal {} ({})", code - 128, strsignal(code - 128))
                    : fmt::format("ended with exit code {}", code);
}

/// Reads what there is; false when its output has ended.
bool ForeignProcess::pump(int timeout_ms) {
  pollfd ends[2] = {{output_, POLLIN, 0}, {errors_, POLLIN, 0}};  // poll leaves out -1
  poll(ends, 2, timeout_ms);
  if (errors_ >= 0 && ends[1].revents != 0 && !read_all(errors_, words_)) close_end(errors_);
  if (words_.size() > 2 * kMostWords) words_.erase(0, words_.size() - kMostWords);
  if (output_ >= 0 && ends[0].revents != 0 && !read_all(output_, unread_)) close_end(output_);
  return output_ >= 0;
}

void ForeignProcess::check_limits(Clock::time_point deadline, double limit_s, Progress& progress) {
  progress.advance(0);
  if (Clock::now() > deadline) fail(fmt::format("took longer than {:g} s", limit_s));
  if (memory_bytes_ == 0 || Clock::now() < next_memory_check_) return;
  next_memory_check_ = Clock::now() + kMemoryInterval;
  const uint64_t used = resident_bytes_of_group(id_);
  if (used > memory_bytes_)
    fail(fmt::format("takes {} MiB of memory, and {} MiB are allowed", used >> 20, memory_bytes_ >> 20));
}

void ForeignProcess::fail(const std::string& problem) {
  kill();
  pump(0);
  const std::string words = last_words();
  fail_environment(
      fmt::format("'{}' {}{}", name_, problem, words.empty() ? "" : "; its last words: " + words));
}

std::string ForeignProcess::last_words() {
  pump(0);
  std::string line;
  for (const char c : words_.substr(words_.size() - std::min(words_.size(), kMostWords))) {
    const bool is_blank = static_cast<unsigned char>(c) <= ' ';
    if (!is_blank) line += static_cast<unsigned char>(c) < 0x7f ? c : '?';
    if (is_blank && !line.empty() && line.back() != ' ') line += ' ';
  }
  while (!line.empty() && line.back() == ' ') line.pop_back();
  return line;
}

void ForeignProcess::write_line(const std::string& line, double limit_s, Progress& progress) {
  const Clock::time_point deadline = deadline_after(limit_s);
  const std::string text = line + "\n";
  size_t sent = 0;
  while (sent < text.size()) {
    const ssize_t count = send(input_, text.data() + sent, text.size() - sent, MSG_NOSIGNAL);
    if (count > 0) {
      sent += static_cast<size_t>(count);
      continue;
    }
    if (count < 0 && errno != EAGAIN && errno != EINTR) {
      for (int i = 0; i < 20 && !has_ended(); ++i) pump(kTick_ms);
      fail(has_ended() ? end_text() : "closed its input");
    }
    pump(kTick_ms);
    check_limits(deadline, limit_s, progress);
  }
}

std::string ForeignProcess::read_line(double limit_s, Progress& progress) {
  const Clock::time_point deadline = deadline_after(limit_s);
  while (true) {
    const size_t end = unread_.find('\n');
    if (std::min(end, unread_.size()) > kLongestLine)
      fail(fmt::format("wrote a line of more than {} bytes", kLongestLine));
    if (end != std::string::npos) {
      std::string line = unread_.substr(0, end);
      unread_.erase(0, end + 1);
      return line;
    }
    if (!pump(kTick_ms) && unread_.find('\n') == std::string::npos) {
      for (int i = 0; i < 20 && !has_ended(); ++i) pump(kTick_ms);
      fail(has_ended() ? end_text() : "closed its output");
    }
    check_limits(deadline, limit_s, progress);
  }
}

int ForeignProcess::wait(double limit_s, Progress& progress) {
  const Clock::time_point deadline = deadline_after(limit_s);
  while (!has_ended()) {
    if (output_ < 0 && errors_ < 0) poll(nullptr, 0, kTick_ms);
    pump(kTick_ms);
    unread_.clear();
    check_limits(deadline, limit_s, progress);
  }
  return *exit_code_;
}

}  // namespace umbrameter
