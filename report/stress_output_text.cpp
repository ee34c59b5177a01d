// SPDX-License-Identifier: Apache-2.0
#include "report/stress_output.h"
#include "results/table_text.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <utility>
#include <vector>

namespace umbrameter {
namespace {

const std::string kMarkdownHead =
    "# Stability\n\nWritten by `umbrameter stress --markdown` (how and why: stress.md). A row holds from the "
    "first "
    "to the last value named, while its error\nstays within twice the nominal one; then what breaks it, and "
    "where. What the program does not name is an axis without a say for that technique.\n\n";

std::string axis_heading(const StressAxis& axis) {
  return axis.unit.empty() ? axis.name : fmt::format("{} [{}]", axis.name, axis.unit);
}

/// Rows by what is to be said of them, in the order in which it is first said.
std::vector<std::pair<std::string, std::vector<std::string>>> by_range(const StressResults& results,
                                                                       const StressAxis& axis) {
  std::vector<std::pair<std::string, std::vector<std::string>>> groups;
  for (const std::string& row : results.rows) {
    const StressRange range = range_of(results, axis, row);
    if (!range.applies && range.why_not == "has no such parameter") continue;
    const std::string text = range.applies ? range_text(range, axis) : "not applicable: " + range.why_not;
    const auto found =
        std::ranges::find(groups, text, &std::pair<std::string, std::vector<std::string>>::first);
    if (found == groups.end()) {
      groups.push_back({text, {row}});
    } else {
      found->second.push_back(row);
    }
  }
  return groups;
}

std::string rows_text(const std::vector<std::string>& rows, const StressResults& results) {
  return rows.size() == results.rows.size() ? "everything" : fmt::format("{}", fmt::join(rows, ", "));
}

std::string nominal_text(const StressAxis& axis) {
  return fmt::format("{} (nominal {})", axis.doc, axis.values[axis.nominal].text);
}

}  // namespace

std::string stress_summary(const StressResults& results) {
  const StressPlan& plan = results.plan;
  return fmt::format(
      "{} axes, {} techniques, {} cells, {} against the rules; {} x {} px, {} samples per pixel, seed {}",
      plan.axes.size(), results.rows.size() - 1, results.cells.size(), results.violations().size(),
      plan.picture.width_px, plan.picture.height_px, plan.picture.samples_per_pixel, plan.picture.seed);
}

std::string violation_text(const StressResults& results, const StressCell& cell) {
  const auto axis = std::ranges::find(results.plan.axes, cell.axis, &StressAxis::name);
  return fmt::format("{} at {}, {}: {}: {}", cell.axis, axis->values[cell.value].text, cell.row,
                     words_for(cell.outcome, cell.how), cell.how);
}

std::string stress_text(const StressResults& results) {
  std::string text;
  for (const StressAxis& axis : results.plan.axes) {
    text += fmt::format("{}: {}\n", axis_heading(axis), nominal_text(axis));
    for (const auto& [range, rows] : by_range(results, axis))
      text += fmt::format("  {}: {}\n", range, rows_text(rows, results));
  }
  for (const StressCell* cell : results.violations())
    text += "against the rules: " + violation_text(results, *cell) + "\n";
  return text + stress_summary(results) + "\n";
}

std::string stress_markdown(const StressResults& results) {
  std::string text = kMarkdownHead + stress_summary(results) + ".\n\n";
  for (const StressAxis& axis : results.plan.axes) {
    text += fmt::format("## {}\n\n{}\n\n| holds | which |\n| --- | --- |\n", axis_heading(axis),
                        nominal_text(axis));
    for (const auto& [range, rows] : by_range(results, axis))
      text += fmt::format("| {} | {} |\n", markdown_cell(range), markdown_cell(rows_text(rows, results)));
    text += "\n";
  }
  text += "## Against the rules\n\n";
  const auto violations = results.violations();
  if (violations.empty()) text += "Nothing.\n";
  for (const StressCell* cell : violations) text += "- " + violation_text(results, *cell) + "\n";
  return text;
}

}  // namespace umbrameter
