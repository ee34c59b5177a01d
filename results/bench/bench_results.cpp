// SPDX-License-Identifier: Apache-2.0
#include "results/bench/bench_results.h"

#include <algorithm>

namespace umbrameter {

bool is_software(const BenchResults& results) {
  return std::ranges::any_of(results.scenes, [](const BenchScene& scene) {
    return std::ranges::any_of(scene.entries, &BenchEntry::is_software);
  });
}

std::vector<Failure> all_failures(const BenchResults& results) {
  std::vector<Failure> failures;
  for (const BenchScene& scene : results.scenes) {
    if (scene.failure) failures.push_back({scene.failure->kind, scene.name + ": " + scene.failure->message});
    for (const BenchEntry& entry : scene.entries) {
      if (!entry.failure) continue;
      failures.push_back(
          {entry.failure->kind, scene.name + ", " + entry.label + ": " + entry.failure->message});
    }
  }
  return failures;
}

std::vector<MeasuredScene> measured_scenes(const BenchResults& results) {
  std::vector<MeasuredScene> scenes;
  for (const BenchScene& scene : results.scenes) {
    MeasuredScene measured;
    measured.name = scene.name;
    measured.scorable_pixels = scene.scorable_pixels;
    measured.why_none = why_none(results.skipped, scene.name, scene.parity.has_value());
    const bool is_void = scene.parity && !scene.parity->passes;
    if (is_void) measured.why_none = "the renderers see other surfaces";
    measured.is_told = scene.failure.has_value();
    for (const BenchEntry& entry : scene.entries) {
      const bool is_scored = !entry.failure && scene.parity && !is_void;
      if (is_scored) measured.scored_pixels.emplace_back(entry.label, scene.scored_pixels);
      measured.is_told = measured.is_told || entry.failure.has_value();
    }
    scenes.push_back(std::move(measured));
  }
  return scenes;
}

}  // namespace umbrameter
