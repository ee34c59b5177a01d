// SPDX-License-Identifier: Apache-2.0
#pragma once
// BenchResults as one JSON object, and as CSV (docs/studies.md).

#include "results/bench/bench_results.h"

#include <optional>
#include <string>

namespace umbrameter {

/// What was asked beside the tables.
struct BenchQueries {
  std::optional<double> best_under_ms;
  std::optional<double> cheapest_below_rmse;
};

/// Indented, ending in a newline; equal results give equal bytes.
std::string to_json_text(const BenchResults& results, const BenchQueries& queries);

/// One line a scene and run under a line of names, fields quoted where needed.
std::string to_csv(const BenchResults& results);
/// The same, a line a scene and setting of the truth.
std::string truth_csv(const BenchResults& results);

}  // namespace umbrameter
