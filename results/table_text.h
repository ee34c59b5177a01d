// SPDX-License-Identifier: Apache-2.0
#pragma once
// Text in tables for people. Not here: HTML (core/html.h).

#include <string>

namespace umbrameter {

/// Every `what` replaced with `with`.
std::string escaped(const std::string& text, char what, const std::string& with);

/// For a cell of a markdown table.
std::string markdown_cell(const std::string& text);

}  // namespace umbrameter
