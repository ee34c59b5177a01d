// SPDX-License-Identifier: Apache-2.0
#include "report/html_table.h"

#include "core/html.h"

#include <fmt/format.h>

namespace umbrameter {

std::string number_cell(std::string_view column, const std::optional<double>& value,
                        const std::string& text) {
  const std::string data = value ? fmt::format("{}", *value) : "";
  return fmt::format("<td class=\"number\" data-column=\"{}\" data-value=\"{}\">{}</td>", column, data,
                     escape_html(text));
}

std::string text_cell(std::string_view text, std::string_view css_class) {
  if (css_class.empty()) return fmt::format("<td>{}</td>", escape_html(text));
  return fmt::format("<td class=\"{}\">{}</td>", css_class, escape_html(text));
}

std::string name_cell(std::string_view name) {
  return fmt::format("<th scope=\"row\">{}</th>", escape_html(name));
}

std::string scroll_table(std::string_view name, const std::vector<Heading>& headings,
                         const std::vector<std::string>& rows) {
  std::string html = fmt::format(
      "<div class=\"table-scroll\" tabindex=\"0\" role=\"region\" aria-label=\"{}\"><table "
      "class=\"sortable\">"
      "<thead><tr>",
      escape_html(name));
  for (const Heading& heading : headings) {
    html += fmt::format("<th scope=\"col\" data-sort=\"{}\"><button type=\"button\">{}</button></th>",
                        heading.is_number ? "number" : "text", escape_html(heading.text));
  }
  html += "</tr></thead><tbody>\n";
  for (const std::string& row : rows) html += "<tr>" + row + "</tr>\n";
  return html + "</tbody></table></div>\n";
}

}  // namespace umbrameter
