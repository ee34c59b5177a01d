// SPDX-License-Identifier: Apache-2.0
#pragma once
// The safe window of a bias: from where it has no acne to where it detaches shadows. An empty window is a finding: no bias
// works there.

#include "study/tune/objective.h"
#include "study/tune/search_space.h"

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace umbrameter {

/// A bias that is a length: real, of group "bias", in texels or world units.
bool is_bias_length(const Parameter& parameter);

inline constexpr double kWindowTolerance = 1e-3;  // share of scored pixels, of acne and of peter-panning

struct BiasPoint {
  double bias = 0.0;
  double objective = 0.0;
  FaultShares shares;
};

/// Absent measures: the run failed there.
using MeasureBias = std::function<std::optional<BiasPoint>(double bias)>;

struct BiasSweep {
  std::string parameter;
  std::string unit;                         // texels or world
  std::vector<BiasPoint> points;            // by bias
  std::optional<double> acne_free_from;     // absent: acne everywhere
  std::optional<double> peter_pan_free_to;  // absent: peter-panning everywhere
  double texel_world = 0.0;                 // median width of a texel on the receivers; 0 when not known
  bool is_complete = true;                  // false: the time was up, and there is no window

  bool has_window() const {
    return acne_free_from && peter_pan_free_to && *acne_free_from <= *peter_pan_free_to;
  }
  /// A length of `unit` in texels and in world units; absent when the texel is not known.
  std::optional<double> texels(double bias) const;
  std::optional<double> world(double bias) const;
};

/// Steps over the axis, then bisection of both ends. `goes_on` is asked before each measurement.
BiasSweep sweep_bias(const Parameter& axis, const MeasureBias& measure, const std::function<bool()>& goes_on);

}  // namespace umbrameter
