// SPDX-License-Identifier: Apache-2.0
#include "view/judge_worker.h"

#include <cmath>

namespace umbrameter {
namespace {

void judge(const JudgeJob& job, JudgeWorker::Desk& desk) {
  Judged judged{job, {}, {}};
  ScoreSettings settings;
  settings.metrics.diagnosis = settings.metrics.significance = settings.metrics.similarity = false;
  judged.score = score_image(*job.test, *job.truth, job.eye_world, settings);
  desk.publish(judged);
  if (job.truth_pass < kFirstProbedPass || !judged.score.error || desk.is_stale()) return;
  judged.score.no_diagnosis = guarded([&] {
    DiagnosedImage diagnosed = diagnose(*job.test, *job.truth, judged.score.mask);
    judged.score.diagnosis = diagnosed.numbers;
    judged.score.fault_classes = std::move(diagnosed.classes);
    judged.profiles = std::move(diagnosed.profiles);
  });
  desk.publish(judged);
  if (desk.is_stale()) return;
  judged.score.similarity = measure_similarity(*job.test, *job.truth, judged.score.mask);
  desk.publish(std::move(judged));
}

}  // namespace

JudgeWorker::Work open_judging() {
  return judge;
}

const PenumbraProfile* profile_near(const std::vector<PenumbraProfile>& profiles, int x, int y) {
  const PenumbraProfile* nearest = nullptr;
  double least_px = 0.0;
  for (const PenumbraProfile& profile : profiles) {
    if (profile.outcome != ProfileOutcome::accepted) continue;
    const double distance_px = std::hypot(profile.x - x, profile.y - y);
    if (distance_px > std::max(profile.reference_width_px, kProbeReach_px)) continue;
    if (nearest != nullptr && distance_px >= least_px) continue;
    nearest = &profile;
    least_px = distance_px;
  }
  return nearest;
}

}  // namespace umbrameter
