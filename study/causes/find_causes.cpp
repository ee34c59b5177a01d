// SPDX-License-Identifier: Apache-2.0
#include "study/causes/find_causes.h"

#include "study/guard.h"

namespace umbrameter {
namespace {

/// The mean over the replacement's lights.
Image draw_all(const Replacement& replacement, const DrawReplaced& draw) {
  Image mean = draw(replacement, replacement.lights.front());
  if (replacement.lights.size() == 1) return mean;
  const auto visibility = mean.plane("visibility");
  std::vector<double> sums(visibility.begin(), visibility.end());
  for (size_t k = 1; k < replacement.lights.size(); ++k) {
    const Image part = draw(replacement, replacement.lights[k]);
    const auto v = part.plane("visibility");
    for (size_t i = 0; i < sums.size(); ++i) sums[i] += v[i];
  }
  for (size_t i = 0; i < sums.size(); ++i)
    visibility[i] = static_cast<float>(sums[i] / static_cast<double>(replacement.lights.size()));
  return mean;
}

}  // namespace

FaultCauses find_causes(const SubstitutedRun& run, const JudgedPicture& judged,
                        std::span<const FaultClass> faults, const DrawReplaced& draw) {
  FaultCauses causes;
  causes.faults = caused_faults(judged.classes, judged.picture, judged.reference, faults);
  for (const Substitution& substitution : substitutions()) {
    const auto replacement = replace(substitution, run);
    if (!replacement) continue;
    SubstitutionOutcome outcome{std::string(substitution.id), replacement->changes, {}, {}, 0.0};
    const auto failure = guarded([&] {
      measure_substitution(draw_all(*replacement, draw), judged.picture, judged.reference, judged.classes,
                           causes.faults, outcome);
    });
    if (failure) outcome.not_tried = failure->message;
    causes.outcomes.push_back(std::move(outcome));
  }
  return causes;
}

double draws_of_causes(const SubstitutedRun& run) {
  double draws = 0.0;
  for (const Substitution& substitution : substitutions()) {
    if (replace(substitution, run)) draws += substitution.draws;
  }
  return draws;
}

}  // namespace umbrameter
