// SPDX-License-Identifier: Apache-2.0
#include "results/bench/claim.h"

namespace umbrameter {

const std::array<std::string, 4>& quantity_names() {
  static const std::array<std::string, 4> names{"time", "fps", "memory", "pass_time"};
  return names;
}

std::string_view to_text(Quantity quantity) {
  return quantity_names()[static_cast<size_t>(quantity)];
}

std::optional<PaperRatio> paper_ratio(const Claim& claim, const std::string& scene) {
  for (const auto& [name, ratio] : claim.by_scene) {
    if (name == scene) return ratio;
  }
  for (const auto& [name, ratio] : claim.by_scene) {
    if (scene.starts_with(name + "/") || scene.starts_with(name + "@")) return ratio;
  }
  return claim.every_scene;
}

}  // namespace umbrameter
