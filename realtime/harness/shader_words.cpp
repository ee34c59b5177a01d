// SPDX-License-Identifier: Apache-2.0
#include "realtime/harness/shader_words.h"

#include <algorithm>
#include <cctype>
#include <unordered_map>

namespace umbrameter {
namespace {

bool is_word_character(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_';
}

/// The first word of `text`, which is cut off from it; empty when there is none.
std::string_view take_word(std::string_view& text) {
  const auto first = std::ranges::find_if(text, is_word_character);
  const auto end = std::find_if_not(first, text.end(), is_word_character);
  const std::string_view word(first, end);
  text = std::string_view(end, text.end());
  return word;
}

std::unordered_map<std::string_view, size_t> count_words(std::string_view text) {
  std::unordered_map<std::string_view, size_t> counts;
  for (std::string_view word = take_word(text); !word.empty(); word = take_word(text)) ++counts[word];
  return counts;
}

/// The macro that a whole line defines; empty for other lines, and where more than the definition would go with the line.
std::string_view defined_macro(std::string_view line) {
  constexpr std::string_view kDefine = "#define ";
  const bool goes_on = line.ends_with('\\') || line.find("/*") != line.npos || line.find("*/") != line.npos;
  if (!line.starts_with(kDefine) || goes_on) return {};
  line.remove_prefix(kDefine.size());
  return take_word(line);
}

}  // namespace

std::vector<std::string> repeated_words(std::string_view text) {
  std::vector<std::string> words;
  for (const auto& [word, count] : count_words(text)) {
    if (count > 1) words.emplace_back(word);
  }
  std::ranges::sort(words);
  return words;
}

std::string without_idle_macros(std::string_view text) {
  const auto counts = count_words(text);
  std::string kept;
  kept.reserve(text.size());
  while (!text.empty()) {
    const size_t end = std::min(text.find('\n'), text.size());
    const std::string_view line = text.substr(0, end);
    const std::string_view macro = defined_macro(line);
    if (macro.empty() || counts.at(macro) > 1) kept += line;
    if (end < text.size()) kept += '\n';
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return kept;
}

}  // namespace umbrameter
