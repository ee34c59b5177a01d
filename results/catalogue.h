// SPDX-License-Identifier: Apache-2.0
#pragma once
// Every number that a run is given, a row each. results.json, CSV, data frames, the terminal's table, the page, baselines and
// docs/metrics.md go through these rows: a new metric is a pair of files that measures it, and a row.

#include "core/image.h"
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

enum class Better : uint8_t { lower, higher, nearest_zero, nearest_one };
std::string_view name_of(Better better);

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
};

struct Metric {
  std::string key;    // "over_shadowing": unique; everywhere that programs read
  std::string label;  // "over-shadowing": everywhere that people read
  std::string group;  // "error"
  std::string unit;   // empty: none
  std::string doc;    // what it is, a sentence without its end
  Better better = Better::lower;
  MetricForm form = MetricForm::error;
  std::string heading = {};  // of its column in the terminal's table; empty: it has none
  /// Where a result holds it; absent values were not measured.
  std::function<std::optional<double>(const TechniqueResult&)> of = {};
  std::function<std::optional<Interval>(const TechniqueResult&)> interval_of = {};  // 95 %; of a few
  /// Measures a row that no other struct holds: its values are in TechniqueResult::measured.
  std::function<std::optional<double>(const MetricInputs&)> measure = {};
};

/// A run of which only these are known, for rows to look at.
TechniqueResult result_of(const Measures& measures);

/// In the order of columns and menus.
const std::vector<Metric>& metric_catalogue();

/// Null when there is none.
const Metric* find_metric(std::string_view key);

/// Values of the rows that have `measure`, by key; absent ones are left out.
std::map<std::string, double> measure_rows(const MetricInputs& inputs);

/// As people read it; "n/a" when absent.
std::string format_metric(const Metric& metric, const TechniqueResult& result);

/// A line for each number of `group` that was measured, but those of regions, which have lines of their own.
TermLines metric_lines(const TechniqueResult& result, std::string_view group);

}  // namespace umbrameter
