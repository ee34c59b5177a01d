// SPDX-License-Identifier: Apache-2.0
#include "study/tune/lengths.h"

#include <algorithm>
#include <limits>

namespace umbrameter {

void resolve_lengths(TunePlan& plan, std::span<const SceneJob> scenes) {
  const auto is_length = [](const Parameter& parameter) { return parameter.is_relative_to_scene; };
  if (scenes.empty() || std::ranges::none_of(plan.parameters, is_length)) return;
  double least = std::numeric_limits<double>::infinity(), most = 0.0;
  for (const SceneJob& job : scenes) {
    least = std::min(least, job.scene.bounds_world.diagonal());
    most = std::max(most, job.scene.bounds_world.diagonal());
  }
  plan.technique.parameters = in_world(plan.parameters, plan.technique.parameters, least);
  for (NamedValues& preset : plan.presets) preset.values = in_world(plan.parameters, preset.values, least);
  for (Parameter& parameter : plan.parameters) parameter = in_world(parameter, least);
  if (least == most) return;
  plan.notes.push_back(fmt::format(
      "ranges and defaults of lengths in world units are those of the smallest scene, {:.4g} across", least));
}

}  // namespace umbrameter
