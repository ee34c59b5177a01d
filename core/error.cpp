// SPDX-License-Identifier: Apache-2.0
#include "core/error.h"

namespace umbrameter {

std::string to_string(const FileLocation& where) {
  if (where.file.empty()) return {};
  if (where.line <= 0) return where.file;
  if (where.column <= 0) return fmt::format("{}:{}", where.file, where.line);
  return fmt::format("{}:{}:{}", where.file, where.line, where.column);
}

namespace {

// Names out of files and compilers' logs may hold anything; a message is one line that no terminal obeys.
std::string one_line(std::string_view text) {
  std::string line;
  for (const char c : text.substr(0, text.find_last_not_of('\n') + 1)) {
    const auto byte = static_cast<unsigned char>(c);
    if (c == '\n')
      line += "; ";
    else
      line += byte < 0x20 || byte == 0x7f ? fmt::format("\\x{:02x}", byte) : std::string(1, c);
  }
  return line;
}

std::string sentence(const std::string& message, const FileLocation& where, const std::string& hint) {
  const std::string place = to_string(where);
  return one_line((place.empty() ? "" : place + ": ") + message + (hint.empty() ? "" : " (" + hint + ")"));
}

}  // namespace

Error::Error(ErrorKind kind, const std::string& message, const FileLocation& where, const std::string& hint)
    : std::runtime_error(sentence(message, where, hint)), kind_(kind), where_(where) {}

void fail_input(const std::string& message, const FileLocation& where, const std::string& hint) {
  throw Error(ErrorKind::input, message, where, hint);
}

void fail_environment(const std::string& message, const std::string& hint) {
  throw Error(ErrorKind::environment, message, {}, hint);
}

void fail_assertion(const char* condition, const std::string& message, const std::source_location& where) {
  throw Error(ErrorKind::internal, fmt::format("{} ({} does not hold)", message, condition),
              {where.file_name(), static_cast<int>(where.line()), 0}, "this is a bug in umbrameter");
}

}  // namespace umbrameter
