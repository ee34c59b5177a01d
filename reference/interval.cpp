// SPDX-License-Identifier: Apache-2.0
#include "reference/interval.h"

#include "reference/reference.h"

#include <algorithm>

namespace umbrameter {

VisibilityInterval interval_95(double visibility, double visibility_se) {
  static_assert(kReplicates == 8);
  constexpr double kStudent7 = 2.3646;     // its 97.5 % point
  constexpr double kRuleOfThree = 2.9957;  // -ln 0.05
  const bool all_agree = visibility <= 0.0 || visibility >= 1.0;
  // Where all agree visibility_se is 0.5 / samples.
  const double reach = visibility_se * (all_agree ? 2.0 * kRuleOfThree : kStudent7);
  return {std::max(0.0, visibility - reach), std::min(1.0, visibility + reach)};
}

}  // namespace umbrameter
