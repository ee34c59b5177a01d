// SPDX-License-Identifier: Apache-2.0
#include "study/stress/judge.h"

#include "core/guard.h"
#include "lab/score.h"
#include "results/catalogue.h"

#include <algorithm>

namespace umbrameter {
namespace {

// Pictures are a few tiles of the default size wide, which would leave no interval.
constexpr int kJudgeTile_px = 8;

std::optional<Interval> rmse_of(const StressMeasure& measure) {
  return measure.run.error ? measure.run.error->rmse : std::nullopt;
}

}  // namespace

double stress_limit_rmse(const Interval& nominal_rmse) {
  return std::max(2.0 * nominal_rmse.high, kLeastStressLimit_rmse);
}

StressCell judge_stress(const StressMeasure& measure, const StressMeasure* nominal) {
  using enum StressOutcome;
  StressCell cell;
  cell.scored_pixels = measure.scored_pixels;
  cell.rmse = rmse_of(measure);
  if (measure.run.failure) {
    cell.outcome = bad_value;
    cell.how = measure.run.failure->message;
  } else if (!cell.rmse) {
    cell.outcome = nothing;
  } else if (nominal == nullptr || !rmse_of(*nominal)) {
    cell.outcome = unjudged;
    cell.how = "there is no nominal error";
  } else if (cell.rmse->low > stress_limit_rmse(*rmse_of(*nominal))) {
    cell.outcome = worse;
    const GateVerdict verdict = judge_gate(measure.run, &nominal->run, true, gate_limits());
    cell.how = verdict.passes() ? name_of(GateClass::error) : name_of(verdict);
  }
  return cell;
}

StressMeasure measure_stress(const Image& picture, const Image& reference, const glm::dvec3& eye_world) {
  StressMeasure out;
  Score score;
  out.run.failure = guarded([&] {
    score = score_image(picture, reference, eye_world, {{.significance = false, .verdict = false}, {}});
    out.run.parity_passes = score.parity.passes;
    out.run.is_other_light = score.parity.is_other_light;
    if (!score.error) return;
    out.run.error = measure_visibility_error(picture, reference, score.mask, {.tile_px = kJudgeTile_px});
    out.scored_pixels = out.run.error->scored_pixels;
  });
  out.run.diagnosis = score.diagnosis;
  out.run.measured = gate_measures(score);
  return out;
}

}  // namespace umbrameter
