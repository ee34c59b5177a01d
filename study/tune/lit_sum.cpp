// SPDX-License-Identifier: Apache-2.0
#include "study/tune/lit_sum.h"

#include <vector>

namespace umbrameter {

std::optional<LitSum> judge_lit_sum(const std::string& scene, std::span<const TunedLight> lights,
                                    Renderer& realtime, Progress& progress) {
  std::vector<View> views;
  std::vector<Image> pictures;
  for (const TunedLight& light : lights) {
    const TunePlan& plan = *light.plan;
    Studio studio(realtime, plan.technique, plan.seed, progress);
    views.push_back(studio.make_view(*light.job, 0.0, plan.full));
    for (const ParameterValues* values : {&plan.technique.parameters, &light.result->best.values})
      pictures.push_back(studio.render(views.back(), *values).image);
  }
  std::vector<LitPart> parts;
  for (size_t i = 0; i < views.size(); ++i)
    parts.push_back({&views[i].reference, views[i].mask, &pictures[2 * i], &pictures[2 * i + 1]});
  std::optional<LitSum> sum = measure_lit_sum(parts);
  if (sum) sum->scene = scene;
  return sum;
}

}  // namespace umbrameter
