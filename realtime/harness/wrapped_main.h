// SPDX-License-Identifier: Apache-2.0
#pragma once
// How a pass's shader gets more to do without its knowing.

#include <string>

namespace umbrameter {

/// For the end of a prelude, once: the shader's main() runs under another name, after `before` and before `after`.
inline std::string wrapped_main(const std::string& before, const std::string& after) {
  return "#define main() main_of_pass(); void main() { " + before + " main_of_pass(); " + after +
         " } void main_of_pass()\n";
}

}  // namespace umbrameter
