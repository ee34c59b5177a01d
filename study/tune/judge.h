// SPDX-License-Identifier: Apache-2.0
#pragma once
// One number for a set of values: the mean over views of the objective's ratio to that of the defaults, so that scenes
// of large errors do not outvote the others.

#include "study/tune/search/trials.h"
#include "study/tune/views.h"

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace umbrameter {

/// Infinite if one is.
double mean_of(const std::vector<double>& ratios);

class Judge {
 public:
  /// Measures `defaults` on all views; Error{input} when one has nothing to measure.
  Judge(Studio& studio, std::vector<View> views, const Objective& objective, const ParameterValues& defaults);

  using Measures = std::vector<std::optional<ObjectiveValue>>;  // one a view

  /// Infinite when a view has no objective or fails. Never renders the same values twice.
  double ratio(const ParameterValues& values) const;

  /// The same on each view.
  std::vector<double> ratios(const ParameterValues& values) const { return ratios_of(measures(values)); }

  /// How much larger `other`'s ratio is than that of `ours` on one view, with its 95 % interval, pixel paired with pixel:
  /// positive where ours is better. Absent for objectives other than rmse, and where a picture fails.
  std::optional<Interval> gain_on(size_t view, const ParameterValues& ours,
                                  const ParameterValues& other) const;

  /// On every view, with intervals; absent where there is no objective, and from where a picture fails.
  const Measures& measures(const ParameterValues& values) const;
  /// The ratios of such measures, one a view.
  std::vector<double> ratios_of(const Measures& measures) const;

  /// Different values rendered so far.
  size_t evaluations() const { return known_.size(); }
  const std::vector<View>& views() const { return views_; }

 private:
  Measures render(const ParameterValues& values) const;
  Measures evaluate(const ParameterValues& values) const;
  /// Of the gain, as a value with its interval.
  std::optional<ObjectiveValue> measured_gain(size_t view, const ParameterValues& ours,
                                              const ParameterValues& other) const;

  Studio& studio_;
  std::vector<View> views_;
  Objective objective_;
  std::vector<double> scales_;                     // the defaults' objective
  mutable std::map<std::string, Measures> known_;  // by values
};

}  // namespace umbrameter
