// SPDX-License-Identifier: Apache-2.0
#pragma once
// What the cells of all axes say together: ranges, what breaks them, and the rules.

#include "study/stress/run.h"

#include <optional>
#include <string>
#include <vector>

namespace umbrameter {

/// One end of a range: the first value beyond it that breaks, and how.
struct StressBreak {
  size_t value = 0;
  StressOutcome outcome = StressOutcome::ok;
  std::string how;
};

/// Where one row holds on one axis: from the nominal value to either side up to the first break. Values that must be
/// refused, that do not concern the row, and pictures without a lit pixel neither break nor widen it.
struct StressRange {
  std::string axis, row;
  bool applies = true;  // else `why_not` says why
  std::string why_not;
  size_t first = 0, last = 0;         // values that hold
  std::optional<StressBreak> before;  // towards the first value
  std::optional<StressBreak> after;   // towards the last
  size_t values = 0, held = 0;        // that say something, and of them within the range

  bool holds_everywhere() const { return !before && !after; }
};

struct StressResults {
  StressPlan plan;
  std::vector<std::string> rows;  // the truth first
  std::vector<StressCell> cells;
  std::string version, commit, device;

  const StressCell* find(const std::string& axis, const std::string& row, size_t value) const;
  /// Cells that break the rules.
  std::vector<const StressCell*> violations() const;
  /// Whether any technique has an error at any value, or was refused where it must be.
  bool measured_anything() const;
  bool passes() const { return violations().empty(); }
};

StressRange range_of(const StressResults& results, const StressAxis& axis, const std::string& row);

/// "acne", "leak", "wrong width", "refused": a word or two for people.
std::string words_for(StressOutcome outcome, const std::string& how);

/// "0 to 1e+04, then leak at 1e+05"; "all values"; "not applicable".
std::string range_text(const StressRange& range, const StressAxis& axis);

}  // namespace umbrameter
