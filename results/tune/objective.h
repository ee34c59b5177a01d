// SPDX-License-Identifier: Apache-2.0
#pragma once
// What a tuner makes small, and the faults that bound a bias or a light's size.

#include "core/image.h"
#include "metrics/statistics/interval.h"

#include <cstdint>
#include <optional>
#include <span>
#include <string>

namespace umbrameter {

/// One of these, or the key of a row of results/catalogue.h that a picture gives (its distance from right):
/// rmse: root of the noise-debiased mean squared error of visibility.
/// penumbra: the row width_error_octaves.
/// faults: sum of the rows' terms (ObjectiveTerm). It is 4 at: a mean absolute error of 0.001 by acne, one of 0.001 by leaks
///   (peter-panning, bleeding, geometric leaks, lost shadows), edges off by a tenth of their penumbra, widths off by half
///   an octave. Terms without support count 0.
struct Objective {
  std::string name = "rmse";
  bool operator==(const Objective&) const = default;
};

/// Error{input} for an unknown name, with the nearest; for a row of several pictures or of times; for a row that is better when
/// higher, whose ratios say nothing.
Objective choose_objective(const std::string& name);
const std::string& name_of(const Objective& objective);
std::string unit_of(const Objective& objective);

/// With its 95 % interval, which `rmse` and `penumbra` have. Absent when there is nothing to measure: no scored pixel, no
/// penumbra in the truth. Without `with_interval` the value alone is asked, which is quicker.
struct ObjectiveValue {
  double value = 0.0;
  std::optional<Interval> interval;
};
std::optional<ObjectiveValue> measure_objective(const Objective& objective, const Image& test,
                                                const Image& reference, std::span<const uint8_t> mask,
                                                bool with_interval);

/// Octaves by which the median penumbra is wider than the truth's, negative where it is narrower; absent without any.
std::optional<double> measure_width_octaves(const Image& test, const Image& reference,
                                            std::span<const uint8_t> mask);

/// Shares of scored pixels.
struct FaultShares {
  double acne = 0.0;
  double peter_panning = 0.0;
};
FaultShares measure_fault_shares(const Image& test, const Image& reference, std::span<const uint8_t> mask);

}  // namespace umbrameter
