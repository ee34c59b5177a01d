// SPDX-License-Identifier: Apache-2.0
#pragma once
// Which of the values that a search found to keep: those that hold on cameras the search did not see, too, and of these the
// plainest.

#include "study/tune/judge.h"
#include "study/tune/search/minimise.h"

#include <span>

namespace umbrameter {

/// Less than this share of the objective is not worth a change.
inline constexpr double kWorthChanging = 2e-3;

/// `by_hand` has the defaults and presets, of which the first five on the cameras searched count. `checked` judges on other cameras than `searched`, or is null. The best of the
/// search's first five on all cameras takes the place of the best by hand if it is better on all together by more than
/// kWorthChanging, and worse neither on the cameras searched nor on those checked; then every value goes back to the one by
/// hand, the weakest first, as long as that costs no more than kWorthChanging.
ParameterValues settle(const SearchSpace& space, const SearchResult& found,
                       std::span<const ParameterValues> by_hand, Judge& searched, Judge* checked);

}  // namespace umbrameter
