// SPDX-License-Identifier: Apache-2.0
#include "study/stress/summary.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

namespace umbrameter {
namespace {

using enum StressOutcome;

/// Neither for nor against a technique.
bool is_silent(StressOutcome outcome) {
  return outcome == nothing || outcome == rightly_refused || outcome == not_applicable;
}

std::optional<StressBreak> break_at(const StressCell* cell, size_t value) {
  if (cell == nullptr || cell->outcome == ok || is_silent(cell->outcome)) return std::nullopt;
  return StressBreak{value, cell->outcome, cell->how};
}

/// Whether any value but the nominal one concerns the row; axes of one value concern all.
bool is_concerned(const StressResults& results, const StressAxis& axis, const std::string& row) {
  if (axis.values.size() == 1) return true;
  for (size_t value = 0; value < axis.values.size(); ++value) {
    const StressCell* cell = results.find(axis.name, row, value);
    const bool concerns = cell != nullptr && cell->outcome != not_applicable;
    if (value != axis.nominal && concerns) return true;
  }
  return false;
}

}  // namespace

bool StressResults::measured_anything() const {
  return std::ranges::any_of(cells, [](const StressCell& cell) {
    return cell.row != kTruthRow &&
           (cell.rmse || cell.outcome == rightly_refused || breaks_rules(cell.outcome));
  });
}

const StressCell* StressResults::find(const std::string& axis, const std::string& row, size_t value) const {
  const auto found = std::ranges::find_if(cells, [&](const StressCell& cell) {
    return cell.value == value && cell.row == row && cell.axis == axis;
  });
  return found == cells.end() ? nullptr : &*found;
}

std::vector<const StressCell*> StressResults::violations() const {
  std::vector<const StressCell*> out;
  for (const StressCell& cell : cells) {
    const bool is_dumb = cell.outcome == refused && cell.how.empty();
    if (breaks_rules(cell.outcome) || is_dumb) out.push_back(&cell);
  }
  return out;
}

StressRange range_of(const StressResults& results, const StressAxis& axis, const std::string& row) {
  StressRange range;
  range.axis = axis.name;
  range.row = row;
  range.first = range.last = axis.nominal;
  const StressCell* nominal = results.find(axis.name, row, axis.nominal);
  if (nominal == nullptr || nominal->outcome != ok) {
    range.applies = false;
    range.why_not = nominal == nullptr                   ? "not run"
                    : nominal->outcome == not_applicable ? nominal->how
                                                         : words_for(nominal->outcome, nominal->how);
    return range;
  }
  if (!is_concerned(results, axis, row)) {
    range.applies = false;
    const StressCell* other = results.find(axis.name, row, axis.nominal == 0 ? 1 : 0);
    range.why_not = other == nullptr ? "not run" : other->how;
    return range;
  }
  for (size_t value = axis.nominal; value-- > 0 && !range.before;) {
    const StressCell* cell = results.find(axis.name, row, value);
    range.before = break_at(cell, value);
    if (cell != nullptr && cell->outcome == ok) range.first = value;
  }
  for (size_t value = axis.nominal + 1; value < axis.values.size() && !range.after; ++value) {
    const StressCell* cell = results.find(axis.name, row, value);
    range.after = break_at(cell, value);
    if (cell != nullptr && cell->outcome == ok) range.last = value;
  }
  for (size_t value = 0; value < axis.values.size(); ++value) {
    const StressCell* cell = results.find(axis.name, row, value);
    if (cell == nullptr || is_silent(cell->outcome)) continue;
    ++range.values;
    if (value >= range.first && value <= range.last) ++range.held;
  }
  return range;
}

std::string words_for(StressOutcome outcome, const std::string& how) {
  constexpr std::array<std::pair<std::string_view, std::string_view>, 6> kFaults = {
      {{"geometric_leak", "leak"},
       {"softness", "wrong width"},
       {"hardening", "wrong hardening"},
       {"offset", "edges displaced"},
       {"bleed", "light bleeding"},
       {"error", "error"}}};
  if (outcome == worse) {
    const auto found = std::ranges::find(kFaults, how, &std::pair<std::string_view, std::string_view>::first);
    std::string text(found == kFaults.end() ? std::string_view(how) : found->second);
    std::ranges::replace(text, '_', ' ');
    return text;
  }
  std::string text(name_of(outcome));
  std::ranges::replace(text, '_', ' ');
  return text;
}

std::string range_text(const StressRange& range, const StressAxis& axis) {
  if (!range.applies) return "not applicable";
  if (range.holds_everywhere()) return "all";
  const auto text = [&](const StressBreak& end) {
    return fmt::format("{} at {}", words_for(end.outcome, end.how), axis.values[end.value].text);
  };
  std::string out = range.first == range.last ? axis.values[range.first].text
                                              : fmt::format("{} to {}", axis.values[range.first].text,
                                                            axis.values[range.last].text);
  if (range.before) out += "; " + text(*range.before);
  if (range.after) out += "; " + text(*range.after);
  return out;
}

}  // namespace umbrameter
