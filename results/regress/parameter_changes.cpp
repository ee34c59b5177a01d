// SPDX-License-Identifier: Apache-2.0
#include "results/regress/parameter_changes.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <map>
#include <sstream>
#include <vector>

namespace umbrameter {
namespace {

/// No value has a space: choices are parts of names in expressions.
std::map<std::string, std::string> values_of(const std::string& text) {
  std::map<std::string, std::string> values;
  std::istringstream words(text);
  for (std::string word; words >> word;) {
    const size_t equals = word.find('=');
    if (equals != std::string::npos) values[word.substr(0, equals)] = word.substr(equals + 1);
  }
  return values;
}

}  // namespace

std::string parameter_changes(const std::string& before, const std::string& now) {
  const auto old = values_of(before), fresh = values_of(now);
  std::vector<std::string> changes;
  for (const auto& [name, value] : fresh) {
    const auto was = old.find(name);
    if (was == old.end()) changes.push_back(fmt::format("{} is new and {}", name, value));
    if (was != old.end() && was->second != value)
      changes.push_back(fmt::format("{} was {} and is {}", name, was->second, value));
  }
  for (const auto& [name, value] : old) {
    if (!fresh.contains(name)) changes.push_back(fmt::format("{} ({}) is gone", name, value));
  }
  return fmt::format("{}", fmt::join(changes, ", "));
}

}  // namespace umbrameter
