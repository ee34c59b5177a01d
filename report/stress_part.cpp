// SPDX-License-Identifier: Apache-2.0
#include "report/stress_part.h"

#include "core/error.h"
#include "core/html.h"
#include "report/facts.h"
#include "report/side_files.h"
#include "study/format.h"
#include "study/run_json.h"
#include "study/stress/summary.h"

#include <fmt/format.h>

#include <map>

namespace umbrameter {
namespace {

using Json = nlohmann::ordered_json;

/// Empty for plain numbers.
std::string unit_of(const Json& axis) {
  const std::string unit = text_of(axis, "unit");
  return unit == "1" ? "" : unit;
}

/// What a person calls it: "leak", "wrong width", "refused".
std::string words_of(const Json& cell) {
  const std::string name = text_of(cell, "outcome");
  for (size_t k = 0; k < kStressOutcomes; ++k) {
    const auto outcome = static_cast<StressOutcome>(k);
    if (name_of(outcome) == name) return words_for(outcome, text_of(cell, "how"));
  }
  fail_input(fmt::format("no outcome of a stress run is called '{}'", name));
}

/// "leak at 1e+05": the first value beyond the range; its sentence when there is more to say.
std::string break_text(const Json& end) {
  const std::string words = words_of(end), how = text_of(end, "how");
  const bool is_sentence = how.find(' ') != std::string::npos;
  return fmt::format("{} at {}{}", words, text_of(end, "value"), is_sentence ? ": " + how : "");
}

std::string range_detail(const Json& range, const std::string& unit) {
  const std::string who = text_of(range, "row") + ", " + text_of(range, "axis") + ": ";
  if (!range.at("applies").get<bool>()) return who + "not applicable: " + text_of(range, "why_not");
  const std::string first = text_of(range, "first"), last = text_of(range, "last");
  std::string text = who + "holds " + (first == last ? "at " + first : "from " + first + " to " + last);
  if (!unit.empty()) text += " " + unit;
  text += fmt::format(" ({} of {} values)", range.at("held").get<size_t>(), range.at("values").get<size_t>());
  for (const char* end : {"break_before", "break_after"}) {
    if (!range.at(end).is_null()) text += "; " + break_text(range.at(end));
  }
  return text;
}

/// From red over yellow to green with the share of the values that hold.
std::string map_cell(const Json& range, const std::string& unit, const std::string& anchor) {
  const std::string detail = escape_html(range_detail(range, unit));
  const auto cell = [&](const std::string& attributes, const std::string& text) {
    return fmt::format(
        "<td role=\"gridcell\" tabindex=\"-1\" data-axis=\"{}\" data-detail=\"{}\" title=\"{}\"{}>{}</td>",
        anchor, detail, detail, attributes, text);
  };
  if (!range.at("applies").get<bool>()) return cell(" class=\"none\"", "-");
  const auto held = range.at("held").get<double>(), values = range.at("values").get<double>();
  const double share = values > 0.0 ? held / values : 0.0;
  const std::string colour = fmt::format(" style=\"background: hsl({:.0f} 70% 50% / 45%)\"", 130.0 * share);
  return cell(colour, held == values ? "all" : fmt::format("{:.0f}/{:.0f}", held, values));
}

std::string axis_anchor(size_t map, const std::string& axis) {
  return fmt::format("stress-{}-{}", map, escape_html(axis));
}

std::string map_table(const Json& stress, size_t map) {
  std::map<std::string, std::map<std::string, const Json*>> ranges;  // by row and axis
  for (const Json& range : stress.at("ranges"))
    ranges[text_of(range, "row")][text_of(range, "axis")] = &range;
  std::string html =
      "<div class=\"table-scroll\"><table class=\"map\" role=\"grid\" aria-label=\"Stability "
      "map\"><thead><tr>"
      "<th scope=\"col\">Technique</th>";
  for (const Json& axis : stress.at("axes")) {
    html += fmt::format("<th scope=\"col\" class=\"upright\"><span>{}</span></th>",
                        escape_html(text_of(axis, "name")));
  }
  html += "</tr></thead><tbody>\n";
  for (const Json& row : stress.at("rows")) {
    const auto name = row.get<std::string>();
    html += fmt::format("<tr><th scope=\"row\">{}</th>", escape_html(name));
    for (const Json& axis : stress.at("axes")) {
      const std::string axis_name = text_of(axis, "name");
      const Json* range = ranges[name][axis_name];
      html += range == nullptr ? "<td role=\"gridcell\" class=\"none\">-</td>"
                               : map_cell(*range, unit_of(axis), axis_anchor(map, axis_name));
    }
    html += "</tr>\n";
  }
  return html +
         "</tbody></table></div>\n<p class=\"map-detail\" role=\"status\">Point at a cell, or Tab to the map "
         "and use the "
         "arrows: its range, the first value that breaks it, and how. Enter unfolds the axis.</p>\n";
}

std::string value_cell(const Json& cell) {
  const auto rmse = read_interval(cell.at("rmse"));
  const std::string outcome = text_of(cell, "outcome"), how = text_of(cell, "how"), words = words_of(cell);
  std::string text = rmse ? format_error(rmse->value) : "";
  if (outcome != "ok" || text.empty()) text += (text.empty() ? "" : " ") + words;
  return fmt::format("<td class=\"{}\"{}>{}</td>", escape_html(outcome),
                     how.empty() || how == words ? "" : " title=\"" + escape_html(how) + "\"",
                     escape_html(text));
}

using CellsOfRow = std::map<std::string, std::map<size_t, const Json*>>;  // by row and value

std::string axis_details(const Json& axis, const Json& rows, CellsOfRow& cells, const std::string& anchor) {
  const std::string unit = unit_of(axis);
  std::string html = fmt::format(
      "<details class=\"facts\" id=\"{}\"><summary>{}{}: {}</summary><div class=\"table-scroll\" "
      "tabindex=\"0\" "
      "role=\"region\" aria-label=\"Axis {}\"><table class=\"map\"><thead><tr><th "
      "scope=\"col\">Technique</th>",
      anchor, escape_html(text_of(axis, "name")), unit.empty() ? "" : " (" + escape_html(unit) + ")",
      escape_html(text_of(axis, "doc")), escape_html(text_of(axis, "name")));
  const Json& values = axis.at("values");
  for (size_t k = 0; k < values.size(); ++k) {
    html += fmt::format("<th scope=\"col\">{}{}</th>", escape_html(values[k].get<std::string>()),
                        k == axis.at("nominal").get<size_t>() ? " (nominal)" : "");
  }
  html += "</tr></thead><tbody>\n";
  for (const Json& row : rows) {
    const auto name = row.get<std::string>();
    html += fmt::format("<tr><th scope=\"row\">{}</th>", escape_html(name));
    for (size_t k = 0; k < values.size(); ++k) {
      const Json* cell = cells[name][k];
      html += cell == nullptr ? "<td class=\"none\">-</td>" : value_cell(*cell);
    }
    html += "</tr>\n";
  }
  return html + "</tbody></table></div></details>\n";
}

std::string map_html(const Json& stress, const std::string& file, size_t map) {
  std::string html = fmt::format(
      "<h3>{}</h3><p class=\"context\">{}: umbrameter {} ({}); {}; {} x {} px, {} samples a pixel, seed "
      "{}</p>\n",
      escape_html(text_of(stress, "title")), escape_html(file), escape_html(text_of(stress, "version")),
      escape_html(text_of(stress, "commit")), escape_html(text_of(stress, "device")),
      stress.at("width_px").get<int>(), stress.at("height_px").get<int>(),
      stress.at("samples_per_pixel").get<int>(), stress.at("seed").get<uint64_t>());
  const auto violations = stress.at("violations").get<std::vector<std::string>>();
  if (!violations.empty()) {
    html += fmt::format("<p class=\"problem\">Against the rules: {}</p><ul class=\"warnings\">{}</ul>\n",
                        violations.size(), list_items(violations));
  }
  html += map_table(stress, map);
  std::map<std::string, CellsOfRow> cells;  // by axis
  for (const Json& cell : stress.at("cells"))
    cells[text_of(cell, "axis")][text_of(cell, "row")][cell.at("value").get<size_t>()] = &cell;
  for (const Json& axis : stress.at("axes")) {
    const std::string name = text_of(axis, "name");
    html += axis_details(axis, stress.at("rows"), cells[name], axis_anchor(map, name));
  }
  return html;
}

}  // namespace

std::string stress_part(const std::filesystem::path& folder) {
  std::string maps;
  size_t count = 0;
  for_side_files(folder, "stress", [&](const Json& document, const std::string& file) {
    maps += map_html(document, file, ++count);
  });
  if (maps.empty()) return {};
  return "<section id=\"stress\"><h2>Stability map</h2>\n<p>Along each axis of difficulty: how many of its "
         "values a technique holds "
         "around the nominal one, the error within twice its nominal value. Green: all of them; red: few; a "
         "dash: does not "
         "apply. Numbers below are RMSE of visibility.</p>\n" +
         maps + "</section>\n";
}

}  // namespace umbrameter
