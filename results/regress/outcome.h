// SPDX-License-Identifier: Apache-2.0
#pragma once
// What a regression found of each case. Not here: the rule (study/regress/judge.h) and where numbers come from (study/regress/run.h).

#include "metrics/gate.h"
#include "results/regress/baseline.h"
#include "results/results.h"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

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
  /// What failed or is undecided: a gate class (metrics/gate.h), "limit", "ratchet", "time", or what kept it from being
  /// compared: "missing", "stale", "scene", "size", "truth". Empty when it passes.
  std::string kind;
  std::string message;  // one sentence; empty when it passes
  GateVerdict gate;     // empty when nothing was compared
};

/// What can never be compared: another scene, other parameters, no baseline.
CaseVerdict not_compared(const std::string& kind, const std::string& message);

/// What the gate calls void, or the numbers of all pictures against this truth.
struct Measured {
  std::optional<CaseVerdict> voided;
  std::optional<CaseNumbers> numbers;
};

/// The label of the case that says that a scene's truth is another; such a case has no numbers.
inline constexpr const char* kTruthLabel = "truth of the scene";

struct RegressCase {
  std::string scene;
  std::string label;
  CaseVerdict verdict;
  int samples_per_pixel = 0;        // of the truth, in the end
  int added_samples_per_pixel = 0;  // because it was not clear
  int pictures = 1;                 // of different seeds
  std::vector<std::string> notes;
  std::optional<BaselineRun> before, now;  // `now` is absent for a void run

  /// Whether an update takes it over: neither the same run nor as good.
  bool has_changed() const;
};

struct RegressScene {
  std::string name;
  std::string hash;
  TruthNumbers truth;
};

struct RegressResults {
  std::string suite;
  int width_px = 0;
  int height_px = 0;
  uint64_t seed = 0;
  std::vector<RegressScene> scenes;
  std::vector<RegressCase> cases;  // in the suite's order, stale ones last
  std::vector<Skip> skipped;

  size_t count(CaseOutcome outcome) const;
  bool passes() const { return count(CaseOutcome::fail) == 0; }
};

/// A fault that was put in.
struct ProvedFault {
  std::string name, scene;
  std::vector<GateClass> right;
  RegressCase found;
  bool is_found() const { return found.verdict.outcome == CaseOutcome::fail; }
  bool is_named() const;
};

}  // namespace umbrameter
