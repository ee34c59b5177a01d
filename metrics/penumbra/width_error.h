// SPDX-License-Identifier: Apache-2.0
#pragma once
// One number for how wrong penumbrae's widths are, to which a destroyed penumbra counts, too.

#include "metrics/penumbra/penumbra.h"
#include "metrics/statistics/interval.h"

#include <optional>
#include <span>

namespace umbrameter {

inline constexpr double kLostOctaves = 4.0;

/// Root mean square of log2(width / true width), in octaves, over all profiles that the truth has. A profile that the test
/// lost or tore counts as kLostOctaves, and no other counts more. Absent without a profile of the truth.
std::optional<double> measure_width_error(std::span<const PenumbraProfile> profiles);

/// Its 95 % interval, from a bootstrap of the profiles; absent for few of them.
std::optional<Interval> width_error_interval(std::span<const PenumbraProfile> profiles);

}  // namespace umbrameter
