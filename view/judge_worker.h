// SPDX-License-Identifier: Apache-2.0
#pragma once
// The metrics of what is in the window, on a thread of their own.

#include "lab/score.h"
#include "view/truth_worker.h"

namespace umbrameter {

struct JudgeJob {
  std::shared_ptr<const Image> test;   // a technique's frame
  std::shared_ptr<const Image> truth;  // of the same place and size
  glm::dvec3 eye_world{0.0};
  uint64_t place_version = 0, run_version = 0;
  int truth_pass = 0;
};

struct Judged {
  JudgeJob job;
  Score score;                            // faults, then similarity, from kFirstProbedPass on
  std::vector<PenumbraProfile> profiles;  // likewise, of the same pair
};

using JudgeWorker = LatestWorker<JudgeJob, Judged>;

JudgeWorker::Work open_judging();

/// The accepted profile nearest to pixel (x, y), no further than it is wide and kProbeReach_px; null without any.
const PenumbraProfile* profile_near(const std::vector<PenumbraProfile>& profiles, int x, int y);
inline constexpr double kProbeReach_px = 24.0;

}  // namespace umbrameter
