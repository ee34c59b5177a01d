// SPDX-License-Identifier: Apache-2.0
#include "engines/host/placeholders.h"

#include "core/names.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <functional>

namespace umbrameter {
namespace {

constexpr std::array<std::string_view, 11> kRequestNames = {
    "scene", "name", "out", "lit", "unlit", "surfaces", "width", "height", "seed", "folder", "installed"};

/// `text` with each {name} replaced by what `value_of` says.
std::string replaced(std::string_view text, const FileLocation& where,
                     const std::function<std::string(const std::string&)>& value_of) {
  std::string out;
  size_t at = 0;
  while (at < text.size()) {
    const size_t open = text.find_first_of("{}", at);
    out += text.substr(at, open - at);
    if (open == std::string_view::npos) return out;
    const size_t close = text.find('}', open);
    if (text[open] == '}' || close == std::string_view::npos)
      fail_input(fmt::format("'{}' has a brace without its partner", text), where,
                 "{name} is replaced by a value");
    out += value_of(std::string(text.substr(open + 1, close - open - 1)));
    at = close + 1;
  }
  return out;
}

}  // namespace

bool is_request_placeholder(std::string_view name) {
  return std::ranges::find(kRequestNames, name) != kRequestNames.end();
}

std::vector<std::string> placeholders_of(EngineForm form) {
  switch (form) {
    case EngineForm::adapter:
      return {"folder", "installed"};
    case EngineForm::command:
      return {kRequestNames.begin(), kRequestNames.end()};
    case EngineForm::pictures:
      return {"name", "width", "height", "seed"};
  }
  return {};
}

std::vector<std::string> split_command(std::string_view command, const FileLocation& where) {
  std::vector<std::string> arguments;
  std::string argument;
  char quote = 0;
  bool is_open = false;
  for (const char c : command) {
    if (quote != 0 && c == quote) {
      quote = 0;
    } else if (quote == 0 && (c == '"' || c == '\'')) {
      quote = c;
      is_open = true;
    } else if (quote == 0 && (c == ' ' || c == '\t' || c == '\n')) {
      if (is_open) arguments.push_back(std::exchange(argument, {}));
      is_open = false;
    } else {
      argument += c;
      is_open = true;
    }
  }
  if (quote != 0) fail_input(fmt::format("the command has a {} without its partner", quote), where);
  if (is_open) arguments.push_back(argument);
  if (arguments.empty()) fail_input("the command is empty", where);
  return arguments;
}

void check_placeholders(std::string_view text, std::span<const std::string> known,
                        const FileLocation& where) {
  replaced(text, where, [&](const std::string& name) -> std::string {
    if (std::ranges::find(known, name) != known.end()) return {};
    fail_input(fmt::format("'{{{}}}' is neither a parameter nor known here", name), where,
               suggest_name(name, known));
  });
}

std::string fill_placeholders(std::string_view text, const PlaceholderValues& values,
                              const FileLocation& where) {
  return replaced(text, where, [&](const std::string& name) -> std::string {
    if (const auto found = values.find(name); found != values.end()) return found->second;
    std::vector<std::string> known;
    for (const auto& [key, value] : values) known.push_back(key);
    fail_input(fmt::format("'{{{}}}' has no value here", name), where, suggest_name(name, known));
  });
}

std::string fill_some(std::string_view text, const PlaceholderValues& values) {
  return replaced(text, {}, [&](const std::string& name) {
    const auto found = values.find(name);
    return found != values.end() ? found->second : "{" + name + "}";
  });
}

}  // namespace umbrameter
