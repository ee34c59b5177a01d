// SPDX-License-Identifier: Apache-2.0
#include "results/measured.h"

#include <fmt/format.h>

namespace umbrameter {

std::optional<std::string> unmeasured(size_t scored, size_t scorable, double min_scored) {
  if (scorable == 0) return "the truth can score no pixel: no surface in the picture faces the light";
  if (scored == 0) return fmt::format("none of the {} pixels that the truth can score was scored", scorable);
  const double share = static_cast<double>(scored) / static_cast<double>(scorable);
  if (share >= min_scored) return std::nullopt;
  return fmt::format(
      "only {:.4g} % of the {} pixels that the truth can score were scored, less than {:.4g} %",
      100.0 * share, scorable, 100.0 * min_scored);
}

std::vector<std::string> unmeasured(std::span<const MeasuredScene> scenes, double min_scored) {
  std::vector<std::string> reasons;
  for (const MeasuredScene& scene : scenes) {
    for (const auto& [label, pixels] : scene.scored_pixels) {
      if (const auto reason = unmeasured(pixels, scene.scorable_pixels, min_scored))
        reasons.push_back(fmt::format("{}, {}: not measured: {}", scene.name, label, *reason));
    }
    if (scene.scored_pixels.empty() && !scene.is_told)
      reasons.push_back(fmt::format("{}: nothing was measured: {}", scene.name, scene.why_none));
  }
  if (scenes.empty()) reasons.emplace_back("nothing was measured: there is no scene");
  return reasons;
}

std::string why_none(const std::vector<Skip>& skipped, const std::string& scene, bool has_truth) {
  size_t runs = 0;
  std::string first;
  for (const Skip& skip : skipped) {
    if (skip.scene != scene || (skip.technique.empty() && has_truth)) continue;
    if (skip.technique.empty()) return skip.reason;
    if (runs++ == 0) first = fmt::format("'{}' {}", skip.technique, skip.reason);
  }
  if (runs == 0) return "there is no run";
  return runs == 1 ? first : fmt::format("{}, and {} more", first, runs - 1);
}

std::vector<MeasuredScene> measured_scenes(const Results& results) {
  std::vector<MeasuredScene> scenes;
  for (const SceneResult& scene : results.scenes) {
    MeasuredScene measured;
    measured.name = scene.name;
    measured.why_none = why_none(results.skipped, scene.name, scene.reference.has_value());
    if (scene.reference) measured.scorable_pixels = scene.reference->scorable_pixels;
    measured.is_told = scene.failure.has_value() || (scene.parity && !scene.parity->passes);
    for (const TechniqueResult& run : scene.techniques) {
      if (run.error) measured.scored_pixels.emplace_back(run.label, run.error->scored_pixels);
      measured.is_told = measured.is_told || run.failure.has_value();
    }
    scenes.push_back(std::move(measured));
  }
  return scenes;
}

}  // namespace umbrameter
