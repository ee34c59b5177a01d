// SPDX-License-Identifier: Apache-2.0
#include "results/results.h"

#include "core/statistics.h"

#include <algorithm>

namespace umbrameter {

ParityNumbers parity_numbers(const Parity& parity, double required_agreement) {
  ParityNumbers numbers;
  numbers.covered = parity.covered;
  numbers.coverage_mismatch = parity.coverage_mismatch;
  numbers.surface_mismatch = parity.surface_mismatch;
  numbers.irradiance_mismatch = parity.irradiance_mismatch;
  numbers.same_primitive = parity.same_primitive;
  numbers.median_relative_depth_error = parity.median_relative_depth_error;
  numbers.agreement = parity.agreement;
  numbers.required_agreement = required_agreement;
  numbers.passes = parity.passes;
  return numbers;
}

std::optional<PassTime> total_time(const std::vector<PassTime>& pass_times) {
  const auto found = std::find_if(pass_times.begin(), pass_times.end(),
                                  [](const PassTime& time) { return time.pass == "total"; });
  return found == pass_times.end() ? std::nullopt : std::optional(*found);
}

std::optional<double> region_rmse(const RegionError& region) {
  if (region.pixels == 0) return std::nullopt;
  return signed_root(region.mse);
}

bool parity_passes(const Results& results) {
  return std::all_of(results.scenes.begin(), results.scenes.end(),
                     [](const SceneResult& scene) { return !scene.parity || scene.parity->passes; });
}

bool exceeds_limit(const Results& results) {
  return std::ranges::any_of(results.scenes, [](const SceneResult& scene) {
    return std::ranges::any_of(scene.techniques, [](const TechniqueResult& run) {
      return run.judgement.limit && run.judgement.limit->outcome == LimitOutcome::fail;
    });
  });
}

std::vector<Failure> all_failures(const Results& results) {
  std::vector<Failure> failures;
  for (const SceneResult& scene : results.scenes) {
    if (scene.failure) failures.push_back({scene.failure->kind, scene.name + ": " + scene.failure->message});
    for (const TechniqueResult& run : scene.techniques) {
      if (!run.failure) continue;
      failures.push_back({run.failure->kind, scene.name + ", " + run.label + ": " + run.failure->message});
    }
  }
  return failures;
}

}  // namespace umbrameter
