// SPDX-License-Identifier: Apache-2.0
#include "cli/console.h"

#include "cli/verbs.h"
#include "results/json/schemas.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdio>

namespace umbrameter {
namespace {

std::string one_line(std::string_view text) {
  std::string line(text);
  std::replace(line.begin(), line.end(), '\n', ' ');
  std::replace(line.begin(), line.end(), '\r', ' ');
  while (!line.empty() && line.back() == ' ') line.pop_back();
  return line;
}

/// Characters of UTF-8 text; continuation bytes do not count.
size_t text_width(const std::string& text) {
  return static_cast<size_t>(std::count_if(
      text.begin(), text.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xC0) != 0x80; }));
}

}  // namespace

void print_error(std::string_view sentence) {
  fmt::print(stderr, "umbrameter: error: {}\n", one_line(sentence));
}
void print_warning(std::string_view sentence) {
  fmt::print(stderr, "umbrameter: warning: {}\n", one_line(sentence));
}
void print_warnings(const std::vector<std::string>& sentences) {
  for (const std::string& sentence : sentences) print_warning(sentence);
}

void print_note(std::string_view sentence) {
  fmt::print(stderr, "umbrameter: {}\n", one_line(sentence));
}

void print_answer(std::string_view text) {
  const bool is_written = std::fwrite(text.data(), 1, text.size(), stdout) == text.size();
  if (!is_written || std::fflush(stdout) != 0) fail_environment("cannot write to standard output");
}

void print_json(const nlohmann::ordered_json& answer) {
  nlohmann::ordered_json json = {{"schema", kAnswerSchema}};
  json.update(answer);  // with the answer's own, if it has one
  print_answer(json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n");
}

std::string format_table(const std::vector<std::string>& headings,
                         const std::vector<std::vector<std::string>>& rows) {
  std::vector<size_t> widths;
  for (size_t column = 0; column < headings.size(); ++column) {
    size_t width = text_width(headings[column]);
    for (const auto& row : rows) width = std::max(width, text_width(row.at(column)));
    widths.push_back(width);
  }
  std::string text;
  const auto add_row = [&](const std::vector<std::string>& cells) {
    std::string line;
    for (size_t column = 0; column < cells.size(); ++column) {
      line += cells[column] + std::string(widths[column] - text_width(cells[column]) + 2, ' ');
    }
    line.erase(line.find_last_not_of(' ') + 1);
    text += line + "\n";
  };
  add_row(headings);
  for (const auto& row : rows) add_row(row);
  return text;
}

int exit_code(ErrorKind kind) {
  switch (kind) {
    case ErrorKind::input:
      return kExitBadInput;
    case ErrorKind::environment:
      return kExitEnvironment;
    case ErrorKind::cancelled:
      return kExitInterrupted;
    case ErrorKind::internal:
      break;
  }
  return kExitInternal;
}

}  // namespace umbrameter
