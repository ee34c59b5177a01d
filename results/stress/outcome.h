// SPDX-License-Identifier: Apache-2.0
#pragma once
// What came of one technique, or of the truth, at one value of an axis.

#include "metrics/error/visibility_error.h"
#include "results/results.h"

#include <nlohmann/json_fwd.hpp>

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace umbrameter {

enum class StressOutcome : uint8_t {
  ok,
  worse,            // the error exceeds twice the nominal one for certain; `how` names the fault
  other_surfaces,   // the renderers see other surfaces, so nothing can be said about shadows
  nothing,          // no pixel that the light can reach
  rightly_refused,  // as it must be
  refused,          // with a sentence
  not_applicable,   // lacks the parameter, or does not support the light
  unjudged,         // there is no nominal error, or no truth
  accepted,         // what must be refused
  wrong_truth,      // against the exact oracle, or against itself
  bad_value,        // NaN, or outside [0,1]
  gl_error,
  environment,  // memory, a limit of the device
  bug,          // Error{internal}
  crash,
  hang,
};
inline constexpr size_t kStressOutcomes = 16;

/// The enumerator's own word, and back; Error{internal} for another.
std::string_view name_of(StressOutcome outcome);
StressOutcome stress_outcome(std::string_view name);

/// What may happen nowhere.
bool breaks_rules(StressOutcome outcome);

/// `row` of the truth; the others are techniques' labels.
inline constexpr std::string_view kTruthRow = "truth";

struct StressCell {
  std::string axis, row;
  size_t value = 0;  // index on the axis
  StressOutcome outcome = StressOutcome::ok;
  std::string how;  // the fault's class, or a sentence
  std::optional<Interval> rmse;
  size_t scored_pixels = 0;
  size_t exact_points = 0;  // compared with the oracle; the truth's
  std::vector<std::string> warnings;
};

nlohmann::ordered_json cell_json(const StressCell& cell);
StressCell read_cell(const nlohmann::json& json);

/// What a renderer threw. Sentences about visibility that is none become bad_value, OpenGL's errors gl_error.
StressOutcome outcome_of(const Failure& failure);

}  // namespace umbrameter
