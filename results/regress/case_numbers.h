// SPDX-License-Identifier: Apache-2.0
#pragma once
// What a regression remembers of a run, by name, so that it can stand in a text file: its error with its noise, and what
// the gate measures. Not here: the file (results/regress/baseline.h) and the rule (study/regress/judge.h).

#include "metrics/gate.h"

#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace umbrameter {

struct CaseNumbers {
  size_t scored_pixels = 0;
  Interval mse;           // 95 % over places
  double noise_sd = 0.0;  // of mse.value, from the truth's samples
  double seed_sd = 0.0;   // of mse.value, from the technique's own noise
  /// Absent ones could not be measured.
  std::map<std::string, double> measures;
};

/// Every measure there can be: the fault classes' parts of the mean absolute error, what tells penumbrae apart, and the
/// catalogue's rows that gates may look at (is_gate_measure).
const std::vector<std::string>& measure_names();

/// Absent for a run that is void, or without scored pixels.
std::optional<CaseNumbers> case_numbers(const GateRun& run);

/// A run with these numbers, as far as the gate looks.
GateRun gate_run_of(const CaseNumbers& numbers);

/// Of several pictures against one truth: their seeds' noise averages out, the truth's does not. Measures that one of
/// them lacks are absent. At least one.
CaseNumbers mean_of(std::span<const CaseNumbers> pictures);

/// sign(mse) sqrt |mse|, with the interval.
Interval rmse_of(const CaseNumbers& numbers);

}  // namespace umbrameter
