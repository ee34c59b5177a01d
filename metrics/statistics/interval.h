// SPDX-License-Identifier: Apache-2.0
#pragma once
// A number and how sure it is.

namespace umbrameter {

/// A number with its 95 % interval.
struct Interval {
  double value = 0.0;
  double low = 0.0;
  double high = 0.0;
};

}  // namespace umbrameter
