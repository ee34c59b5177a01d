// SPDX-License-Identifier: Apache-2.0
#pragma once
// Every number that a run is given, a row each. results.json, CSV, data frames, the terminal's table, the page, baselines and
// docs/metrics.md go through these rows: a new metric is a pair of files that measures it, and a row.

#include "core/image.h"
#include "metrics/better.h"
#include "metrics/gate.h"
#include "metrics/temporal/history.h"
#include "results/diagnosis_format.h"
#include "results/results.h"

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace umbrameter {

/// What a run must have for a row to have a number.
enum class MetricNeeds : uint8_t {
  picture,   // and the truth's
  sequence,  // several pictures
  timing     // of drawing it
};
std::string_view name_of(MetricNeeds needs);

/// Of what gates make of a row: `kind` is the class that stands for it, and then its measure is the gate's own, such as a root
/// mean square where the row has a median (metrics/gate.h). Without a class it is the row's own distance from right.
struct RowGate {
  GateClass kind = GateClass::measured;
  GateLimit limit;
};

/// Part of the tuner's objective `faults`: rows of one term add up, and their sum counts 1 at `one`.
struct ObjectiveTerm {
  std::string name;
  double one = 1.0;
};

/// How the number is written.
enum class MetricForm : uint8_t {
  error,
  signed_error,
  share,
  number,
  octaves,
  decibels,
  milliseconds,
  bytes
};
std::string_view name_of(MetricForm form);

/// What a row may measure from. `test` and `reference` as for measure_visibility_error.
struct MetricInputs {
  const Image& test;
  const Image& reference;
  std::span<const uint8_t> mask;
  // Of a technique with history (lab/history.h); none of others.
  const Image* still = nullptr;                       // where something moved: the picture if nothing had
  std::span<const StillPicture> still_pictures = {};  // after ever more frames
  std::span<const PenumbraProfile> profiles = {};     // of a diagnosis; none without one
};

struct Metric {
  std::string key;        // "over_shadowing": unique; everywhere that programs read
  std::string label;      // "over-shadowing": everywhere that people read
  std::string group;      // "error"
  std::string unit = {};  // empty: none
  std::string doc;        // what it is, a sentence without its end
  Better better = Better::lower;
  MetricForm form = MetricForm::error;
  std::string heading = {};  // of its column in the terminal's table; empty: it has none
  /// Where a result holds it; absent values were not measured.
  std::function<std::optional<double>(const TechniqueResult&)> of = {};
  std::function<std::optional<Interval>(const TechniqueResult&)> interval_of = {};  // 95 %; of a few
  /// Measures a row that no other struct holds: its values are in TechniqueResult::measured.
  std::function<std::optional<double>(const MetricInputs&)> measure = {};
  MetricNeeds needs = MetricNeeds::picture;
  std::optional<RowGate> gate = {};  // absent: gates look at it where a suite says so (is_gate_measure)
  std::optional<ObjectiveTerm> term = {};
};

/// A run of which only these are known, for rows to look at.
TechniqueResult result_of(const Measures& measures);

/// In the order of columns and menus.
const std::vector<Metric>& metric_catalogue();

/// Null when there is none.
const Metric* find_metric(std::string_view key);

/// How far a run's number is from right; lower is better. Absent like the number.
std::optional<double> badness(const Metric& metric, const TechniqueResult& result);

/// Whether a gate may look at the row's own number, which no class stands for: it has a limit, or it is measured from the
/// pictures. Not of those that are better when higher: shares of them say nothing.
bool is_gate_measure(const Metric& metric);
/// The numbers of those rows, by key.
std::map<std::string, double> gate_measures(const Measures& measures);
/// The classes' limits, and those of the rows.
GateLimits gate_limits();

/// Values of the rows that have `measure`, by key; absent ones are left out.
std::map<std::string, double> measure_rows(const MetricInputs& inputs);

/// As people read it; "n/a" when absent.
std::string format_metric(const Metric& metric, const TechniqueResult& result);

/// A line for each number of `group` that was measured, but those of regions, which have lines of their own.
TermLines metric_lines(const TechniqueResult& result, std::string_view group);

}  // namespace umbrameter
