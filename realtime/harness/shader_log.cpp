// SPDX-License-Identifier: Apache-2.0
#include "realtime/harness/shader_source.h"

#include <fmt/format.h>

#include <regex>
#include <sstream>
#include <string_view>

namespace umbrameter {

namespace {

/// Numbers too long for int (a garbled log) count as unknown.
int number_of(const std::ssub_match& match) {
  return match.length() < 9 ? std::stoi(match.str()) : 0;
}

FileLocation place(const std::ssub_match& source_number, const std::ssub_match& line, int column,
                   const ShaderSource& source) {
  const auto number = static_cast<size_t>(number_of(source_number));
  if (number >= source.files.size()) return {};
  return {source.files[number], number_of(line), column};
}

/// "error: x", "preprocessor error: x", "error C1234: x" -> "x", and whether it is one.
ShaderMessage read_message(const std::string& text) {
  static const std::regex kSeverity(
      R"(^\s*((?:preprocessor\s+)?(?:fatal\s+)?error|warning|note)\b[^:]*:\s*(.*)$)", std::regex::icase);
  std::smatch match;
  if (!std::regex_match(text, match, kSeverity)) return {{}, text, false};
  const bool is_error = match[1].str().find("rror") != std::string::npos || match[1].str() == "ERROR";
  return {{}, match[2].str(), is_error};
}

ShaderMessage parse_line(const std::string& line, const ShaderSource& source) {
  static const std::regex kMesa(R"(^(\d+):(\d+)\((\d+)\)\s*:\s*(.*)$)");
  static const std::regex kNvidia(R"(^(\d+)\((\d+)\)\s*:\s*(.*)$)");
  static const std::regex kGlslang(R"(^(ERROR|WARNING):\s*(\d+):(\d+):\s*(.*)$)");
  std::smatch match;
  ShaderMessage message;
  if (std::regex_match(line, match, kMesa)) {
    message = read_message(match[4].str());
    message.where = place(match[1], match[2], number_of(match[3]), source);
  } else if (std::regex_match(line, match, kNvidia)) {
    message = read_message(match[3].str());
    message.where = place(match[1], match[2], 0, source);
  } else if (std::regex_match(line, match, kGlslang)) {
    message = {place(match[2], match[3], 0, source), match[4].str(), match[1].str() == "ERROR"};
  } else {
    message = read_message(line);
  }
  return message;
}

}  // namespace

std::vector<ShaderMessage> parse_shader_log(std::string_view log, const ShaderSource& source) {
  std::vector<ShaderMessage> messages;
  std::istringstream lines{std::string(log)};
  for (std::string line; std::getline(lines, line);) {
    if (line.find_first_not_of(" \t\r") == std::string::npos) continue;
    messages.push_back(parse_line(line, source));
  }
  return messages;
}

std::string missing_read_hint(const std::string& message) {
  static const std::regex kRead(R"([`'"](previous_)?(gbuffer|noise|scene)_([a-z_]+)['"])");
  const bool is_missing =
      message.find("undeclared") != std::string::npos || message.find("undefined") != std::string::npos;
  std::smatch match;
  if (!is_missing || !std::regex_search(message, match, kRead)) return {};
  const std::string_view previous = match[1].matched ? "previous." : "";
  return fmt::format("list '{}{}.{}' in the pass's 'reads'", previous, match[2].str(), match[3].str());
}

}  // namespace umbrameter
