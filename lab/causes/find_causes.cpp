// SPDX-License-Identifier: Apache-2.0
#include "lab/causes/find_causes.h"

#include "core/guard.h"
#include "core/statistics.h"

#include <cmath>

namespace umbrameter {
namespace {

constexpr double kSameTexels = 0.01;  // a length that differs by less is the same

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

/// Median over the pixels of how many of the one's texels go into one of the other's; 1 where either does not tell.
double texels_per_texel(const Image& larger, const Image& smaller) {
  if (!larger.has("texel_world") || !smaller.has("texel_world")) return 1.0;
  const auto a = larger.plane("texel_world"), b = smaller.plane("texel_world");
  std::vector<double> ratios;
  for (size_t i = 0; i < a.size(); ++i) {
    if (a[i] > 0.0f && b[i] > 0.0f) ratios.push_back(static_cast<double>(a[i]) / b[i]);
  }
  return ratios.empty() ? 1.0 : median(std::move(ratios));
}

/// With lengths in texels as long in the world as in `judged`; notes them in the replacement.
Image draw_substituted(const SubstitutedRun& run, const Image& judged, Replacement& replacement,
                       const DrawReplaced& draw) {
  Image drawn = draw_all(replacement, draw);
  if (!replacement.moves_texels) return drawn;
  const double factor = texels_per_texel(judged, drawn);
  if (std::abs(factor - 1.0) < kSameTexels || !keep_lengths(run, factor, replacement)) return drawn;
  return draw_all(replacement, draw);
}

}  // namespace

FaultCauses find_causes(const SubstitutedRun& run, const JudgedPicture& judged,
                        std::span<const FaultClass> faults, const DrawReplaced& draw) {
  FaultCauses causes;
  causes.faults = caused_faults(judged.classes, judged.picture, judged.reference, faults);
  for (const Substitution& substitution : substitutions()) {
    auto replacement = replace(substitution, run);
    if (!replacement) continue;
    SubstitutionOutcome outcome{std::string(substitution.id), {}, {}, {}, 0.0};
    const auto failure = guarded([&] {
      const Image drawn = draw_substituted(run, judged.picture, *replacement, draw);
      measure_substitution(drawn, judged.picture, judged.reference, judged.classes, causes.faults, outcome);
    });
    outcome.changes = replacement->changes;
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
