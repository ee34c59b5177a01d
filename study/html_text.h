#pragma once
// Text in tables for people. Not here: the report's page (report/).

#include <string>

namespace umbrameter {

/// Every `what` replaced with `with`.
std::string escaped(const std::string& text, char what, const std::string& with);

std::string html_escaped(const std::string& text);
/// For a cell of a markdown table.
std::string markdown_cell(const std::string& text);

}  // namespace umbrameter
