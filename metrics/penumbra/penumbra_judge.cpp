// SPDX-License-Identifier: Apache-2.0
#include "metrics/penumbra/penumbra_judge.h"

#include "metrics/statistics/isotonic.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <vector>

namespace umbrameter {

namespace {

// Both ends of a stretch bend towards its turning points, whose height the test need not share.
constexpr double kTrimmedShare = 0.1;
// A pixel's position along the walk is exact, so a noise-free profile may leave its fit by rounding only.
constexpr double kRounding = 0.01;

struct Curve {
  std::vector<double> position, value, fitted;
};

// Samples of both sides and the seed, by position: on a slanted edge neighbours may come in either order.
Curve curve_of(std::span<const float> values, const WalkedProfile& walked, size_t dark_count,
               size_t bright_count) {
  const auto& dark = walked.dark.samples;
  const auto& bright = walked.bright.samples;
  std::vector<WalkSample> samples(dark.begin(), dark.begin() + static_cast<long>(dark_count));
  samples.push_back({walked.seed, 0.0});
  samples.insert(samples.end(), bright.begin(), bright.begin() + static_cast<long>(bright_count));
  std::stable_sort(samples.begin(), samples.end(),
                   [](const WalkSample& a, const WalkSample& b) { return a.s_world < b.s_world; });
  Curve curve;
  for (const WalkSample& sample : samples) {
    curve.position.push_back(sample.s_world);
    curve.value.push_back(values[sample.pixel]);
  }
  curve.fitted = fit_nondecreasing(curve.value);
  return curve;
}

Curve reference_curve(const WalkedProfile& walked) {
  return curve_of(walked.field.visibility, walked, walked.dark.reference_count,
                  walked.bright.reference_count);
}

Curve test_curve(const WalkedProfile& walked) {
  return curve_of(walked.test, walked, walked.dark.test_count, walked.bright.test_count);
}

double rms_of_fit(const Curve& curve) {
  double sum = 0.0;
  for (size_t i = 0; i < curve.value.size(); ++i)
    sum += (curve.value[i] - curve.fitted[i]) * (curve.value[i] - curve.fitted[i]);
  return std::sqrt(sum / static_cast<double>(curve.value.size()));
}

double rms_of_noise(const WalkedProfile& walked) {
  const Curve noise = curve_of(walked.field.visibility_se, walked, walked.dark.reference_count,
                               walked.bright.reference_count);
  double sum = 0.0;
  for (const double value : noise.value) sum += value * value;
  return std::sqrt(sum / static_cast<double>(noise.value.size()));
}

bool is_monotone(const WalkedProfile& walked, const Curve& reference) {
  return rms_of_fit(reference) <= 3.0 * rms_of_noise(walked) + kRounding;
}

bool spans(const Curve& curve, double reach) {
  return curve.fitted.front() <= 1.0 - reach && curve.fitted.back() >= reach;
}

bool is_broken(const Walk& walk) {
  return walk.end == WalkEnd::broken;
}

double px_per_world(const WalkedProfile& walked, const Curve& curve) {
  const double walked_px =
      glm::length(walked.ascent.direction_px) * static_cast<double>(curve.value.size() - 1);
  return walked_px / (curve.position.back() - curve.position.front());
}

/// A reference too sharp to be resolved has a width of 0, as has a test that is as sharp.
double octaves(double test, double reference, double hardest_share) {
  if (!(reference > 0.0)) return test > 0.0 ? -std::log2(hardest_share) : 0.0;
  return std::log2(std::max(test / reference, hardest_share));
}

// `span` of the levels: a stretch of a box ramp is that part of it.
void set_reference(const Transition& reference, double span, double px_per_world, PenumbraProfile& profile) {
  profile.reference_width_world = reference.width / span;
  profile.reference_width_10_90_world = reference.width_10_90 / span;
  profile.reference_width_px = profile.reference_width_world * px_per_world;
}

// Edges lie where half the light is left; a stretch's middle may be at another level, half-way to it by the width.
void set_test(const Transition& test, const Transition& reference, const Levels& levels,
              const PenumbraSettings& settings, PenumbraProfile& profile) {
  const double span = levels.high - levels.low, to_half = 0.5 - 0.5 * (levels.low + levels.high);
  profile.test_width_world = test.width / span;
  profile.test_width_10_90_world = test.width_10_90 / span;
  profile.width_octaves = octaves(test.resolved_width, reference.resolved_width, settings.hardest_share);
  profile.width_10_90_octaves =
      octaves(test.resolved_width_10_90, reference.width_10_90, settings.hardest_share);
  profile.offset_world = test.center - reference.center + to_half * (test.width - reference.width) / span;
}

void count_levels(const WalkedProfile& walked, PenumbraProfile& profile) {
  std::vector<long> levels;
  const auto add = [&](size_t i) {
    if (walked.field.visibility[i] > 0.05f && walked.field.visibility[i] < 0.95f)
      levels.push_back(std::lround(4096.0 * walked.test[i]));
  };
  add(walked.seed);
  for (const Walk* walk : {&walked.dark, &walked.bright}) {
    for (size_t k = 0; k < walk->reference_count; ++k) add(walk->samples[k].pixel);
  }
  profile.ramp_px = levels.size();
  std::sort(levels.begin(), levels.end());
  profile.ramp_levels = static_cast<size_t>(std::unique(levels.begin(), levels.end()) - levels.begin());
}

ProfileOutcome judge_test(const WalkedProfile& walked, const Transition& reference,
                          const PenumbraSettings& settings, PenumbraProfile& profile) {
  const Curve test = test_curve(walked);
  if (!spans(test, settings.test_reach)) return ProfileOutcome::test_unreached;
  const bool cut_dark = walked.dark.test_cut && test.fitted.front() > 1.0 - settings.reach;
  const bool cut_bright = walked.bright.test_cut && test.fitted.back() < settings.reach;
  if (cut_dark || cut_bright) return ProfileOutcome::test_unreached;
  if (rms_of_fit(test) > settings.max_test_rms) return ProfileOutcome::test_not_monotone;
  const auto transition = measure_transition(test.position, test.fitted);
  if (!transition) return ProfileOutcome::test_unreached;
  set_test(*transition, reference, {0.0, 1.0}, settings, profile);
  return ProfileOutcome::accepted;
}

void judge_whole(const WalkedProfile& walked, const Curve& curve, const PenumbraSettings& settings,
                 PenumbraProfile& profile) {
  profile.outcome = ProfileOutcome::not_monotone;
  if (!is_monotone(walked, curve)) return;
  profile.outcome = ProfileOutcome::unreached;
  const auto reference = measure_transition(curve.position, curve.fitted);
  if (!reference) return;
  set_reference(*reference, 1.0, px_per_world(walked, curve), profile);
  PenumbraProfile judged = profile;
  judged.outcome = judge_test(walked, *reference, settings, judged);
  if (judged.outcome == ProfileOutcome::accepted) judged.edge_offset_world = judged.offset_world;
  // A step between two samples has no width to compare with, however far apart they are.
  if (profile.reference_width_px < settings.min_width_px || !(reference->resolved_width > 0.0)) {
    profile.outcome = ProfileOutcome::too_narrow;
    profile.edge_offset_world = judged.edge_offset_world;
    return;
  }
  count_levels(walked, judged);
  profile = judged;
}

}  // namespace

void judge_stretch(const WalkedProfile& walked, const PenumbraSettings& settings, PenumbraProfile& profile) {
  const Curve curve = reference_curve(walked), test = test_curve(walked);
  if (curve.fitted.back() - curve.fitted.front() < settings.least_levels || !is_monotone(walked, curve))
    return;
  const Levels shared = {std::max(curve.fitted.front(), test.fitted.front()),
                         std::min(curve.fitted.back(), test.fitted.back())};
  const double span = shared.high - shared.low;
  if (span < settings.least_test_levels || rms_of_fit(test) > settings.max_test_rms) return;
  const Levels levels = {shared.low + kTrimmedShare * span, shared.high - kTrimmedShare * span};
  const auto of_reference = measure_transition(curve.position, curve.fitted, levels);
  const auto of_test = measure_transition(test.position, test.fitted, levels);
  if (!of_reference || !of_test || !(of_reference->resolved_width > 0.0)) return;

  PenumbraProfile judged = profile;
  set_reference(*of_reference, levels.high - levels.low, px_per_world(walked, curve), judged);
  if (judged.reference_width_px < settings.min_width_px) return;
  // The envelope's scale is the slope's, as of any profile that is not whole.
  judged.reference_width_px = profile.reference_width_px;
  set_test(*of_test, *of_reference, levels, settings, judged);
  count_levels(walked, judged);
  judged.outcome = ProfileOutcome::accepted;
  judged.edge_offset_world = judged.offset_world;
  judged.is_partial = true;
  profile = judged;
}

void judge_profile(const WalkedProfile& walked, const PenumbraSettings& settings, PenumbraProfile& profile) {
  const Curve curve = reference_curve(walked);
  const Walk &dark = walked.dark, &bright = walked.bright;
  const bool saturated = dark.end == WalkEnd::saturated && bright.end == WalkEnd::saturated;
  if (saturated || spans(curve, settings.reach)) return judge_whole(walked, curve, settings, profile);
  const bool broken = is_broken(dark) || is_broken(bright);
  profile.outcome = broken ? ProfileOutcome::discontinuity : ProfileOutcome::unreached;
  profile.overlaps = !broken;
  judge_stretch(walked, settings, profile);
}

}  // namespace umbrameter
