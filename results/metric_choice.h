// SPDX-License-Identifier: Apache-2.0
#pragma once
// Which metrics a score consists of.

#include <string_view>

namespace umbrameter {

/// Beside parity and the visibility error, on which everything rests and which cost little. A verdict against a
/// baseline counts as `verdict`; a limit is of the visibility error alone.
struct MetricChoice {
  bool significance = true;
  bool verdict = true;
  bool diagnosis = true;
  bool similarity = true;
};

inline constexpr const char* kMetricsHelp =
    "comma-separated: error, significance, verdict, diagnosis, similarity (default: all; error is always "
    "there)";

inline constexpr const char* kMapsHelp =
    "also write the metrics' answers pixel by pixel: an EXR of z, fault class, width error and FLIP a run";

/// "error,significance,verdict,diagnosis,similarity" or a part of it; empty = all. Error{input} for an unknown name.
MetricChoice choose_metrics(std::string_view list);

}  // namespace umbrameter
