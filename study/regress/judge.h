// SPDX-License-Identifier: Apache-2.0
#pragma once
// The rule of a regression: a run's numbers against the baseline's, against truth both (docs/regress.md). Not here: where
// numbers come from (study/regress/run.h).

#include "study/regress/baseline.h"
#include "study/regress/suite_file.h"

#include <optional>
#include <string>

namespace umbrameter {

enum class CaseOutcome : uint8_t {
  pass,
  better,     // for certain
  undecided,  // more samples would tell
  fail,
};
std::string_view name_of(CaseOutcome outcome);

struct CaseVerdict {
  CaseOutcome outcome = CaseOutcome::pass;
  /// What failed or is undecided: a gate class (study/gate.h), "limit", "ratchet", "time", or what kept it from being
  /// compared: "missing", "stale", "scene", "size", "truth". Empty when it passes.
  std::string kind;
  std::string message;  // one sentence; empty when it passes
  GateVerdict gate;     // empty when nothing was compared
};

/// What can never be compared: another scene, other parameters, no baseline.
CaseVerdict not_compared(const std::string& kind, const std::string& message);

/// By the gate first, then the limits, then the ratchet. Frame times are judged by judge_time.
CaseVerdict judge_case(const CaseNumbers& now, const CaseNumbers& before, const RegressGates& gates);

/// Fails when the time's lower end is above the ratio times the baseline's upper end, each three robust standard
/// deviations of its median wide. Absent when it passes.
std::optional<CaseVerdict> judge_time(const BaselineTime& now, const BaselineTime& before, double ratio);

}  // namespace umbrameter
