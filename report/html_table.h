// SPDX-License-Identifier: Apache-2.0
#pragma once
// Cells and tables of the page, escaped. report/assets/table.js sorts them.

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace umbrameter {

/// A number that sorts by its full-precision value; absent ones sort last.
std::string number_cell(std::string_view column, const std::optional<double>& value, const std::string& text);
std::string text_cell(std::string_view text, std::string_view css_class = {});
/// The cell that names its row.
std::string name_cell(std::string_view name);

struct Heading {
  std::string text;
  bool is_number = false;  // cells of this column are number_cells
};

/// A table that scrolls within itself where it is too wide. `rows`: cells of each, without <tr>.
std::string scroll_table(std::string_view name, const std::vector<Heading>& headings,
                         const std::vector<std::string>& rows);

}  // namespace umbrameter
