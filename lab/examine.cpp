// SPDX-License-Identifier: Apache-2.0
#include "lab/examine.h"

#include "lab/score.h"
#include "metrics/error/truth_check.h"
#include "metrics/image/shadow_quantity.h"
#include "results/catalogue.h"
#include "results/measured.h"

namespace umbrameter {

Examined examine(const Image& picture, const Image& truth, const glm::dvec3& eye_world,
                 const ErrorMetric& metric) {
  Examined out;
  out.run.metric_problems = metric_problems(metric);
  Score score;
  std::optional<Image> made;
  out.run.failure =
      guarded([&] { score = score_image(picture, truth_for(picture, truth, made), eye_world); });
  if (out.run.failure) return out;
  out.run.parity_passes = score.parity.passes;
  out.run.is_other_light = score.parity.is_other_light;
  if (!score.parity.passes) return out;
  if (const auto reason = unmeasured(score.error->scored_pixels, score.scorable_pixels)) {
    out.run.failure = Failure{ErrorKind::input, *reason};
    return out;
  }
  out.run.truth_problems = truth_problems(truth, score.mask);
  out.run.error = score.error;
  out.run.diagnosis = score.diagnosis;
  out.run.measured = gate_measures(score);
  out.run.failure = score.no_diagnosis;
  out.mask = std::move(score.mask);
  out.fault_classes = std::move(score.fault_classes);
  return out;
}

}  // namespace umbrameter
