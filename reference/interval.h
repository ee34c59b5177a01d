// SPDX-License-Identifier: Apache-2.0
#pragma once
// What a visibility and its standard error say about the truth.

namespace umbrameter {

struct VisibilityInterval {
  double low = 0.0;
  double high = 0.0;
};

/// Holds the true visibility in 95 of 100 pixels. Otherwise than for the few pixels whose samples all agree it is
/// Student's t with the replicates' 7 degrees of freedom; there it is the rule of three, 3 / samples on the open side,
/// and where se is 0 the proven value alone.
VisibilityInterval interval_95(double visibility, double visibility_se);

}  // namespace umbrameter
