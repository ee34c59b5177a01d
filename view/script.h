// SPDX-License-Identifier: Apache-2.0
#pragma once
// Keys, mouse and waiting as lines of text, so that a window can be driven without a hand (docs/view.md).

#include "core/error.h"

#include <string>
#include <string_view>
#include <vector>

namespace umbrameter {

/// One line: a command and its words.
struct ScriptStep {
  std::string command;
  std::vector<std::string> words;
  FileLocation where;
  /// Error{input} unless word `index` is a number.
  double number(size_t index) const;
};

/// Lines of `text`; "#" begins a comment. Error{input} at its line for an unknown command or a wrong number of words.
std::vector<ScriptStep> parse_script(std::string_view text, const std::string& file);

/// GLFW's number of a key: "A", "1", "SPACE", "TAB", "PAGE_DOWN", "F2", ...; -1 for what is none.
int key_of(std::string_view name);

}  // namespace umbrameter
