#pragma once
// Lines of comma-separated values.

#include <string>
#include <vector>

namespace umbrameter {

/// Nine significant digits.
std::string csv_number(double value);

/// One line, cells quoted where needed.
std::string csv_line(const std::vector<std::string>& cells);

}  // namespace umbrameter
