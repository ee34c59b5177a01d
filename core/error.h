// SPDX-License-Identifier: Apache-2.0
#pragma once
// How every room reports what went wrong. Not here: logging and exit codes (cli/).

#include <fmt/format.h>

#include <source_location>
#include <stdexcept>
#include <string>
#include <string_view>

namespace umbrameter {

/// Who has to act: the user (input), the machine (environment), us (internal), nobody (cancelled).
enum class ErrorKind { input, environment, internal, cancelled };

/// A place in a file; line and column are 1-based, 0 = unknown.
struct FileLocation {
  std::string file;
  int line = 0;
  int column = 0;
};

/// "file:line:column", leaving out what is unknown; empty when the file is unknown.
std::string to_string(const FileLocation& where);

/// The one exception type. `what()` is one sentence: "file:line:column: message (hint)".
/// Caught in cli/main.cpp and by the per-run guard in study/, nowhere else.
class Error : public std::runtime_error {
 public:
  Error(ErrorKind kind, const std::string& message, const FileLocation& where = {},
        const std::string& hint = {});
  ErrorKind kind() const { return kind_; }
  const FileLocation& where() const { return where_; }

 private:
  ErrorKind kind_;
  FileLocation where_;
};

/// The input is wrong: throws Error{input}.
[[noreturn]] void fail_input(const std::string& message, const FileLocation& where = {},
                             const std::string& hint = {});
/// The machine lacks something: throws Error{environment}.
[[noreturn]] void fail_environment(const std::string& message, const std::string& hint = {});

/// Throws Error{internal} naming the source line; used by UMBRAMETER_ASSERT.
[[noreturn]] void fail_assertion(const char* condition, const std::string& message,
                                 const std::source_location& where = std::source_location::current());

}  // namespace umbrameter

/// A condition only our own bug can break. Always on: the checks are outside hot loops.
#define UMBRAMETER_ASSERT(condition, ...)                                                 \
  do {                                                                                    \
    if (!(condition)) ::umbrameter::fail_assertion(#condition, fmt::format(__VA_ARGS__)); \
  } while (false)
