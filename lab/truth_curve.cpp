// SPDX-License-Identifier: Apache-2.0
#include "lab/truth_curve.h"

#include "core/clock.h"
#include "core/error.h"
#include "metrics/error/visibility_error.h"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

namespace umbrameter {
namespace {

std::vector<uint8_t> surface_mask(const Image& image) {
  const auto id = image.plane("primitive_id");
  std::vector<uint8_t> mask(id.size());
  std::ranges::transform(id, mask.begin(), [](float primitive) { return primitive < 0.0f ? 0 : 1; });
  return mask;
}

double mean_samples(const Image& image) {
  const auto samples = image.plane("sample_count");
  return std::accumulate(samples.begin(), samples.end(), 0.0) / static_cast<double>(samples.size());
}

Renderer& judge_of(const TruthPlan& plan) {
  const auto judge = std::find_if(plan.settings.rbegin(), plan.settings.rend(),
                                  [](const TruthSetting& each) { return each.kind == "target_se"; });
  UMBRAMETER_ASSERT(judge != plan.settings.rend(), "a truth by target_se must judge the others");
  return *judge->renderer;
}

}  // namespace

TruthCurve measure_truth(const Scene& scene, const RenderRequest& request, const TruthPlan& plan,
                         Progress& progress) {
  RenderRequest others = request;
  others.seed = ~request.seed;
  const Image judge = judge_of(plan).render(scene, others, progress).image;  // also builds the scene
  const std::vector<uint8_t> mask = surface_mask(judge);
  TruthCurve curve;
  std::vector<std::vector<double>> cpu_s(plan.settings.size());
  for (int repetition = 0; repetition < plan.repetitions; ++repetition) {
    for (size_t i = 0; i < plan.settings.size(); ++i) {
      const TruthSetting& setting = plan.settings[i];
      const double before_s = process_cpu_seconds();
      const Frame frame = setting.renderer->render(scene, request, progress);
      cpu_s[i].push_back(process_cpu_seconds() - before_s);
      if (repetition > 0) continue;
      const VisibilityError error = measure_visibility_error(frame.image, judge, mask);
      curve.points.push_back({setting.kind, setting.setting, {}, mean_samples(frame.image), error.rmse});
    }
  }
  for (size_t i = 0; i < curve.points.size(); ++i) curve.points[i].cpu_s = median_spread(cpu_s[i]);
  curve.exponent = convergence_exponent(curve.points);
  return curve;
}

}  // namespace umbrameter
