// SPDX-License-Identifier: Apache-2.0
#pragma once
// Of which runs the causes of faults are looked for.

#include <cstdint>
#include <string_view>

namespace umbrameter {

enum class CausesWanted : uint8_t {
  none,
  automatic,  // of a scene's three worst runs, as long as that takes less time than the scene itself
  worst,      // of the three, whatever it takes
  all,
};

inline constexpr size_t kWorstRuns = 3;

/// "none", "auto", "worst" or "all"; Error{input} otherwise.
CausesWanted choose_causes(std::string_view text);

}  // namespace umbrameter
