// SPDX-License-Identifier: Apache-2.0
#pragma once
// Formats are told by a file's ending, in capitals or not.

#include <algorithm>
#include <string_view>

namespace umbrameter {

/// `ending` in small letters, as ".obj".
inline bool has_ending(std::string_view file, std::string_view ending) {
  if (file.size() < ending.size()) return false;
  const auto small = [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; };
  return std::equal(ending.begin(), ending.end(), file.end() - static_cast<std::ptrdiff_t>(ending.size()),
                    [&](char a, char b) { return a == small(b); });
}

}  // namespace umbrameter
