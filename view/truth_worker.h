// SPDX-License-Identifier: Apache-2.0
#pragma once
// The truth of a place, refined pass by pass on a thread of its own.

#include "view/draw_worker.h"

namespace umbrameter {

/// How far a truth is.
struct TruthPass {
  Place place;
  std::shared_ptr<const Image> image;  // channels of a reference; blockers' from kFirstProbedPass on
  int pass = 0;                        // from 0
  int passes = 0;
  double promised_se = 1.0;  // the renderer's target_se; where there is none, the most there can be
  double se_max = 0.0;       // greatest standard error of visibility among the pixels that count
  double se_rms = 0.0;
  double wall_time_s = 0.0;  // since the place was asked for, all passes
};

/// Blockers are probed from this pass on: what faults and penumbrae are told by.
inline constexpr int kFirstProbedPass = 1;

using TruthWorker = LatestWorker<Place, TruthPass>;

/// What a TruthWorker opens: a few samples everywhere, then as many as a standard error of 0.02 takes, then of 0.005. Every
/// pass publishes its result. `threads`: as in ReferenceSettings.
TruthWorker::Work open_truth(Scene scene, int threads);

}  // namespace umbrameter
