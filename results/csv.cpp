// SPDX-License-Identifier: Apache-2.0
#include "results/csv.h"

#include <fmt/format.h>

namespace umbrameter {
namespace {

std::string quoted(const std::string& text) {
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string result = "\"";
  for (const char c : text) {
    if (c == '"') result += '"';
    result += c;
  }
  return result + '"';
}

}  // namespace

std::string csv_number(double value) {
  return fmt::format("{:.9g}", value);
}

std::string csv_line(const std::vector<std::string>& cells) {
  std::string text;
  bool is_first = true;
  for (const std::string& cell : cells) {
    if (!is_first) text += ',';
    text += quoted(cell);
    is_first = false;
  }
  return text + "\n";
}

void add_interval(const std::optional<Interval>& interval, std::vector<std::string>& cells) {
  for (const auto part : {&Interval::value, &Interval::low, &Interval::high})
    cells.push_back(interval ? csv_number((*interval).*part) : "");
}

}  // namespace umbrameter
