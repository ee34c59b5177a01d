#pragma once
// One number for a set of values: the mean over views of the objective's ratio to that of the defaults, so that scenes
// of large errors do not outvote the others.

#include "study/tune/trials.h"
#include "study/tune/views.h"

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace umbrameter {

class Judge {
 public:
  /// Measures `defaults` on all views; Error{input} when one has nothing to measure.
  Judge(Studio& studio, std::vector<View> views, Objective objective, const ParameterValues& defaults);

  /// Infinite when a view has no objective or fails. Never renders the same values twice.
  double ratio(const ParameterValues& values);

  /// On one view, with its interval; absent as above.
  std::optional<ObjectiveValue> measure(size_t view, const ParameterValues& values) const;
  /// The mean ratio of such measures, one a view.
  double ratio_of(const std::vector<std::optional<ObjectiveValue>>& measures) const;

  /// Different values rendered so far.
  size_t evaluations() const { return known_.size(); }
  const std::vector<View>& views() const { return views_; }

 private:
  std::optional<ObjectiveValue> measure(size_t view, const ParameterValues& values, bool with_interval) const;

  Studio& studio_;
  std::vector<View> views_;
  Objective objective_;
  std::vector<double> scales_;  // the defaults' objective
  std::map<std::string, double> known_;
};

}  // namespace umbrameter
