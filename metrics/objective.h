// SPDX-License-Identifier: Apache-2.0
#pragma once
// What a tuner makes small (METRICS 6.13), and the shares of acne and peter-panning that bound a bias.

#include "metrics/error/visibility_error.h"

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace umbrameter {

/// rmse: root of the noise-debiased mean squared error of visibility.
/// penumbra: root mean square of log2(width / true width), in octaves. A profile that the test lost or tore counts as
///   kLostOctaves, so that destroying penumbrae does not help.
/// faults: weighted sum; each term is 1 at: a mean absolute error of 0.001 by acne, one of 0.001 by leaks
///   (peter-panning, bleeding, geometric leaks, lost shadows), edges off by a tenth of their penumbra, widths off by half
///   an octave. Terms without support count 0.
enum class Objective : uint8_t { rmse, penumbra, faults };

inline constexpr double kLostOctaves = 4.0;

/// Error{input} with the nearest name otherwise.
Objective choose_objective(const std::string& name);
std::string_view name_of(Objective objective);
std::string_view unit_of(Objective objective);

/// The objective with its 95 % interval; `faults` has none. Absent when there is nothing to measure: no scored pixel, no
/// penumbra in the truth. Without `with_interval` the value alone is asked, which is quicker.
struct ObjectiveValue {
  double value = 0.0;
  std::optional<Interval> interval;
};
std::optional<ObjectiveValue> measure_objective(Objective objective, const Image& test,
                                                const Image& reference, std::span<const uint8_t> mask,
                                                bool with_interval);

/// Shares of scored pixels.
struct FaultShares {
  double acne = 0.0;
  double peter_panning = 0.0;
};
/// Octaves by which the median penumbra is wider than the truth's, negative where it is narrower; absent without any.
std::optional<double> measure_width_octaves(const Image& test, const Image& reference,
                                            std::span<const uint8_t> mask);
FaultShares measure_fault_shares(const Image& test, const Image& reference, std::span<const uint8_t> mask);

}  // namespace umbrameter
