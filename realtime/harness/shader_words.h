// SPDX-License-Identifier: Apache-2.0
#pragma once
// What a shader's text names, found without understanding it: comments and branches that are not compiled count, too.

#include <string>
#include <string_view>
#include <vector>

namespace umbrameter {

/// Identifiers that stand more than once in `text`, in alphabetical order: of inputs, those that are declared and read.
std::vector<std::string> repeated_words(std::string_view text);

/// `text` with an empty line in place of every macro that it defines and names nowhere else, so that shaders that differ in
/// such macros alone are one.
std::string without_idle_macros(std::string_view text);

}  // namespace umbrameter
