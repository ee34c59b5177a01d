// SPDX-License-Identifier: Apache-2.0
#include "results/bench/recommend.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace umbrameter {
namespace {

double product(const BenchEntry& entry) {
  return entry.time_ms->high * entry.rmse()->high;
}

/// Of one run over scenes.
struct SceneSum {
  double log_cost = 0.0;
  size_t scenes = 0;
};

/// Logarithm of the least product of each label over the scene's least.
std::map<std::string, double> costs_in(const BenchScene& scene) {
  std::map<std::string, double> costs;
  const auto best = recommended(scene.entries);
  if (!best) return costs;
  for (const BenchEntry& entry : scene.entries) {
    if (!entry.has_place) continue;
    const double cost = std::log(product(entry) / product(scene.entries[*best]));
    const auto [found, is_new] = costs.emplace(entry.label, cost);
    if (!is_new) found->second = std::min(found->second, cost);
  }
  return costs;
}

}  // namespace

std::optional<size_t> recommended(std::span<const BenchEntry> entries) {
  std::optional<size_t> best;
  for (size_t i = 0; i < entries.size(); ++i) {
    if (!entries[i].has_place || !(product(entries[i]) > 0.0)) continue;
    if (!best || product(entries[i]) < product(entries[*best])) best = i;
  }
  return best;
}

std::optional<OverallRecommendation> recommended_overall(std::span<const BenchScene> scenes) {
  std::map<std::string, SceneSum> sums;
  size_t most_scenes = 0;
  for (const BenchScene& scene : scenes) {
    for (const auto& [label, cost] : costs_in(scene)) {
      SceneSum& sum = sums[label];
      sum.log_cost += cost;
      most_scenes = std::max(most_scenes, ++sum.scenes);
    }
  }
  std::optional<OverallRecommendation> best;
  for (const auto& [label, sum] : sums) {
    if (sum.scenes < most_scenes) continue;
    const double cost = std::exp(sum.log_cost / static_cast<double>(sum.scenes));
    if (!best || cost < best->cost) best = {label, cost, sum.scenes};
  }
  return best;
}

}  // namespace umbrameter
