// SPDX-License-Identifier: Apache-2.0
#pragma once
// Numbers as people read them; the terminal table and the report show the same text.

#include "results/results.h"

#include <optional>
#include <string>

namespace umbrameter {

inline constexpr const char* kNotApplicable = "n/a";

/// A visibility error to five decimals: "0.01234"; "n/a" when absent.
std::string format_error(const std::optional<double>& value);
/// The same with its sign: "+0.00123".
std::string format_signed_error(const std::optional<double>& value);
/// "0.01234 [0.01200, 0.01270]".
std::string format_interval(const std::optional<Interval>& interval);
/// "1.234 ± 0.012 ms (9 frames)"; one frame has no spread: "1.234 ms (1 frame)"; "n/a" when not timed.
std::string format_time(const std::optional<PassTime>& time);
/// "16.0 MiB".
std::string format_bytes(uint64_t bytes);
/// A share as percent: "99.981 %". Never rounds up to 100.
std::string format_share(double share);
/// "agreement 99.981 % of 12345 covered pixels (needs 99.500 %): passes", and what disagrees.
std::string format_parity(const ParityNumbers& parity);

/// "plate, pcf: does not support sun lights (saves about 0.2 s)".
std::string format_skip(const Skip& skip);
/// "flicker 0.012 (truth 0.003) under a moving camera, 0.02 under a moving light, 0.001 over seeds".
std::string format_temporal(const TemporalNumbers& temporal);
/// "after 15 frames (light): ghosting +0.012, frames to converge 7.7", of a run with history; the numbers where measured.
std::string format_history(const TechniqueResult& run);

}  // namespace umbrameter
