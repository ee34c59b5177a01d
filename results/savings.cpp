// SPDX-License-Identifier: Apache-2.0
#include "results/savings.h"

#include "core/statistics.h"

#include <fmt/format.h>

namespace umbrameter {
namespace {

template <class Wanted>
std::optional<double> median_time_s(const Results& results, const Wanted& is_wanted) {
  std::vector<double> times_s;
  for (const SceneResult& scene : results.scenes) {
    for (const TechniqueResult& run : scene.techniques) {
      if (!run.failure && is_wanted(scene, run)) times_s.push_back(run.wall_time_s);
    }
  }
  return median_if_any(std::move(times_s));
}

std::optional<double> time_of_run(const Results& results, const Skip& skip) {
  const auto same_run = median_time_s(
      results, [&](const SceneResult&, const TechniqueResult& run) { return run.label == skip.technique; });
  if (same_run) return same_run;
  return median_time_s(
      results, [&](const SceneResult& scene, const TechniqueResult&) { return scene.name == skip.scene; });
}

/// As if the pixels with and without a proof cost alike; absent where all have one.
std::optional<Skip> proven_pixels(const SceneResult& scene) {
  if (!scene.reference) return std::nullopt;
  const ReferenceResult& truth = *scene.reference;
  const double proven = truth.proven_lit_share + truth.proven_dark_share;
  if (proven == 0.0) return std::nullopt;
  Skip skip{
      scene.name, "",
      fmt::format("no rays for {:.1f} % of the pixels that are proven to be lit and {:.1f} % proven dark",
                  100.0 * truth.proven_lit_share, 100.0 * truth.proven_dark_share)};
  if (proven < 1.0) skip.saved_s = truth.wall_time_s * proven / (1.0 - proven);
  return skip;
}

}  // namespace

void add_savings(Results& results) {
  for (Skip& skip : results.skipped) {
    if (!skip.technique.empty()) skip.saved_s = time_of_run(results, skip);
  }
  for (const SceneResult& scene : results.scenes) {
    if (auto skip = proven_pixels(scene)) results.skipped.push_back(std::move(*skip));
  }
}

}  // namespace umbrameter
