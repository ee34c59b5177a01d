// SPDX-License-Identifier: Apache-2.0
#pragma once
// Times on the command line: "1ms", "800us", "0.5 s", "2min".

#include <string>

namespace umbrameter {

/// Error{input} naming `option` for anything but a positive number and its unit.
double milliseconds(const std::string& option, const std::string& text);

}  // namespace umbrameter
