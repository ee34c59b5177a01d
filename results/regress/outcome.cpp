// SPDX-License-Identifier: Apache-2.0
#include "results/regress/outcome.h"

#include <algorithm>
#include <array>

namespace umbrameter {

std::string_view name_of(CaseOutcome outcome) {
  constexpr std::array<std::string_view, 4> kNames = {"pass", "better", "undecided", "fail"};
  return kNames[static_cast<size_t>(outcome)];
}

CaseVerdict not_compared(const std::string& kind, const std::string& message) {
  return {CaseOutcome::fail, kind, message, {}};
}

bool RegressCase::has_changed() const {
  const bool is_fine = verdict.outcome == CaseOutcome::pass || verdict.outcome == CaseOutcome::undecided;
  return !is_fine || (before && now && before->parameters != now->parameters);
}

size_t RegressResults::count(CaseOutcome outcome) const {
  return static_cast<size_t>(
      std::ranges::count_if(cases, [&](const RegressCase& one) { return one.verdict.outcome == outcome; }));
}

bool ProvedFault::is_named() const {
  return std::ranges::any_of(right, [&](GateClass kind) { return name_of(kind) == found.verdict.kind; });
}

}  // namespace umbrameter
