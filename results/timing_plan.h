// SPDX-License-Identifier: Apache-2.0
#pragma once
// How long frames are timed.

namespace umbrameter {

struct TimingPlan {
  int wanted_frames = 9;  // a run; 0 = no timing
  double budget_s = 3.0;  // a run; slow ones get fewer frames, never fewer than 1
};

}  // namespace umbrameter
