// SPDX-License-Identifier: Apache-2.0
#pragma once
// Lines of comma-separated values.

#include "metrics/error/visibility_error.h"

#include <optional>
#include <string>
#include <vector>

namespace umbrameter {

/// Nine significant digits.
std::string csv_number(double value);

/// One line, cells quoted where needed.
std::string csv_line(const std::vector<std::string>& cells);

/// Value, low and high; three empty cells when absent.
void add_interval(const std::optional<Interval>& interval, std::vector<std::string>& cells);

}  // namespace umbrameter
