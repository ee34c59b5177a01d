// SPDX-License-Identifier: Apache-2.0
#include "report/stress_output.h"
#include "results/json/json_parts.h"
#include "results/json/schemas.h"

#include <nlohmann/json.hpp>

namespace umbrameter {
namespace {

using OrderedJson = nlohmann::ordered_json;

OrderedJson axis_json(const StressAxis& axis) {
  OrderedJson values = OrderedJson::array();
  for (const StressValue& value : axis.values) values.push_back(value.text);
  return {{"name", axis.name},
          {"unit", axis.unit},
          {"doc", axis.doc},
          {"values", values},
          {"nominal", axis.nominal}};
}

OrderedJson break_json(const std::optional<StressBreak>& end, const StressAxis& axis) {
  if (!end) return nullptr;
  return {{"value", axis.values[end->value].text}, {"outcome", name_of(end->outcome)}, {"how", end->how}};
}

OrderedJson range_json(const StressRange& range, const StressAxis& axis) {
  if (!range.applies)
    return {{"axis", range.axis}, {"row", range.row}, {"applies", false}, {"why_not", range.why_not}};
  return {{"axis", range.axis},
          {"row", range.row},
          {"applies", true},
          {"first", axis.values[range.first].text},
          {"last", axis.values[range.last].text},
          {"break_before", break_json(range.before, axis)},
          {"break_after", break_json(range.after, axis)},
          {"values", range.values},
          {"held", range.held}};
}

}  // namespace

std::string stress_json(const StressResults& results) {
  OrderedJson axes = OrderedJson::array(), cells = OrderedJson::array(), ranges = OrderedJson::array(),
              violations = OrderedJson::array();
  for (const StressAxis& axis : results.plan.axes) {
    axes.push_back(axis_json(axis));
    for (const std::string& row : results.rows)
      ranges.push_back(range_json(range_of(results, axis, row), axis));
  }
  for (const StressCell& cell : results.cells) cells.push_back(cell_json(cell));
  for (const StressCell* cell : results.violations()) violations.push_back(violation_text(results, *cell));
  return dump({{"schema", kStressSchema.number},
               {"title", results.plan.title},
               {"version", results.version},
               {"commit", results.commit},
               {"device", results.device},
               {"width_px", results.plan.picture.width_px},
               {"height_px", results.plan.picture.height_px},
               {"samples_per_pixel", results.plan.picture.samples_per_pixel},
               {"seed", results.plan.picture.seed},
               {"passes", results.passes()},
               {"axes", axes},
               {"rows", results.rows},
               {"ranges", ranges},
               {"violations", violations},
               {"cells", cells}});
}

}  // namespace umbrameter
