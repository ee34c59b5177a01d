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
};

inline constexpr const char* kMetricsHelp =
    "comma-separated: error, significance, verdict, diagnosis (default: all; error is always there)";

/// "error,significance,verdict,diagnosis" or a part of it; empty = all. Error{input} for an unknown name.
MetricChoice choose_metrics(std::string_view list);

}  // namespace umbrameter
