// SPDX-License-Identifier: Apache-2.0
#include "core/html.h"
#include "study/stress/output.h"

#include <fmt/format.h>

namespace umbrameter {
namespace {

constexpr const char* kHead =
    "<!doctype html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><meta name=\"viewport\" "
    "content=\"width=device-width\">\n<title>Stability map</title>\n<style>\n"
    ":root { color-scheme: light dark; font: 14px/1.4 system-ui, sans-serif }\n"
    ".wide { overflow-x: auto } table { border-collapse: collapse; margin: .5em 0 1.5em }\n"
    "td, th { padding: .3em .5em; text-align: left; vertical-align: top; border: 1px solid #8886; font-size: "
    ".85em }\n"
    "tbody th { position: sticky; left: 0; background: Canvas }\n"
    ".ok { background: #2f9e5166 } .none { color: #888 } .silent { background: #88888822 }\n"
    ".refused { background: #d0a03055 } .worse { background: #e0702055 } .rule { background: #d01030aa }\n"
    "</style></head><body>\n";

const char* style_of(StressOutcome outcome) {
  using enum StressOutcome;
  if (breaks_rules(outcome)) return "rule";
  switch (outcome) {
    case ok:
      return "ok";
    case worse:
    case other_surfaces:
      return "worse";
    case refused:
    case environment:
      return "refused";
    case not_applicable:
      return "none";
    default:
      return "silent";
  }
}

/// From red over yellow to green with the share of the values that hold.
std::string colour_of(const StressRange& range) {
  const double share = range.values > 0 ? double(range.held) / double(range.values) : 0.0;
  return fmt::format("hsl({:.0f} 70% 50% / 45%)", 130.0 * share);
}

std::string map_cell(const StressResults& results, const StressAxis& axis, const std::string& row) {
  const StressRange range = range_of(results, axis, row);
  if (!range.applies)
    return fmt::format("<td class=\"none\" title=\"{}\">-</td>", escape_html(range.why_not));
  std::string title = fmt::format("{} of {} values", range.held, range.values);
  for (const auto& end : {range.before, range.after}) {
    if (end) title += fmt::format("; {}: {}", axis.values[end->value].text, end->how);
  }
  return fmt::format("<td style=\"background: {}\" title=\"{}\">{}</td>", colour_of(range),
                     escape_html(title), escape_html(range_text(range, axis)));
}

std::string map_table(const StressResults& results) {
  std::string text = "<div class=\"wide\"><table><thead><tr><th scope=\"col\">technique</th>";
  for (const StressAxis& axis : results.plan.axes) {
    text += fmt::format("<th scope=\"col\"><a href=\"#{0}\">{0}</a><br>{1}</th>", escape_html(axis.name),
                        escape_html(axis.unit));
  }
  text += "</tr></thead><tbody>\n";
  for (const std::string& row : results.rows) {
    text += "<tr><th scope=\"row\">" + escape_html(row) + "</th>";
    for (const StressAxis& axis : results.plan.axes) text += map_cell(results, axis, row);
    text += "</tr>\n";
  }
  return text + "</tbody></table></div>\n";
}

std::string cell_text(const StressCell& cell) {
  const std::string words = words_for(cell.outcome, cell.how);
  return cell.rmse ? fmt::format("{:.4f}{}", cell.rmse->value,
                                 cell.outcome == StressOutcome::ok ? "" : "<br>" + escape_html(words))
                   : escape_html(words);
}

std::string axis_table(const StressResults& results, const StressAxis& axis) {
  std::string text =
      fmt::format("<h2 id=\"{0}\">{0}</h2>\n<p>{1}</p>\n<div class=\"wide\"><table><thead><tr><th></th>",
                  escape_html(axis.name), escape_html(axis.doc));
  for (size_t value = 0; value < axis.values.size(); ++value) {
    text += fmt::format("<th scope=\"col\">{}{}</th>", escape_html(axis.values[value].text),
                        value == axis.nominal ? "<br>nominal" : "");
  }
  text += "</tr></thead><tbody>\n";
  for (const std::string& row : results.rows) {
    text += "<tr><th scope=\"row\">" + escape_html(row) + "</th>";
    for (size_t value = 0; value < axis.values.size(); ++value) {
      const StressCell* cell = results.find(axis.name, row, value);
      if (cell == nullptr) {
        text += "<td class=\"none\">-</td>";
        continue;
      }
      text += fmt::format("<td class=\"{}\" title=\"{}\">{}</td>", style_of(cell->outcome),
                          escape_html(cell->how), cell_text(*cell));
    }
    text += "</tr>\n";
  }
  return text + "</tbody></table></div>\n";
}

}  // namespace

std::string stress_html(const StressResults& results) {
  std::string text =
      std::string(kHead) + "<h1>Stability map</h1>\n<p>" + escape_html(stress_summary(results)) +
      ". Ranges over which the error stays within twice its nominal value, and the first value "
      "that breaks it; green holds everywhere. Numbers are RMSE of visibility.</p>\n" +
      map_table(results);
  const auto violations = results.violations();
  text += fmt::format("<h2>Against the rules: {}</h2>\n<ul>\n", violations.size());
  for (const StressCell* cell : violations)
    text += "<li>" + escape_html(violation_text(results, *cell)) + "</li>\n";
  text += "</ul>\n";
  for (const StressAxis& axis : results.plan.axes) text += axis_table(results, axis);
  return text + "</body></html>\n";
}

}  // namespace umbrameter
