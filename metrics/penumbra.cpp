// SPDX-License-Identifier: Apache-2.0
#include "metrics/penumbra.h"

#include "core/error.h"
#include "metrics/checks.h"
#include "metrics/isotonic.h"
#include "metrics/penumbra_walk.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace umbrameter {

namespace {

struct Curve {
  std::vector<double> position, value;
};

// Samples of both sides and the seed, by position: on a slanted edge neighbours may come in either order.
Curve curve_of(std::span<const float> values, size_t seed, const Walk& dark, size_t dark_count,
               const Walk& bright, size_t bright_count) {
  std::vector<WalkSample> samples(dark.samples.begin(), dark.samples.begin() + static_cast<long>(dark_count));
  samples.push_back({seed, 0.0});
  samples.insert(samples.end(), bright.samples.begin(),
                 bright.samples.begin() + static_cast<long>(bright_count));
  std::stable_sort(samples.begin(), samples.end(),
                   [](const WalkSample& a, const WalkSample& b) { return a.s_world < b.s_world; });
  Curve curve;
  for (const WalkSample& sample : samples) {
    curve.position.push_back(sample.s_world);
    curve.value.push_back(values[sample.pixel]);
  }
  return curve;
}

double rms_between(std::span<const double> a, std::span<const double> b) {
  double sum = 0.0;
  for (size_t i = 0; i < a.size(); ++i) sum += (a[i] - b[i]) * (a[i] - b[i]);
  return std::sqrt(sum / static_cast<double>(a.size()));
}

double rms(std::span<const double> values) {
  const std::vector<double> zero(values.size(), 0.0);
  return rms_between(values, zero);
}

bool spans(const std::vector<double>& fitted, double reach) {
  return fitted.front() <= 1.0 - reach && fitted.back() >= reach;
}

bool broken(const Walk& walk) {
  return walk.end == WalkEnd::broken;
}

ProfileOutcome judge_reference(const ReferenceField& field, size_t seed, const Ascent& ascent,
                               const Walk& dark, const Walk& bright, const PenumbraSettings& settings,
                               PenumbraProfile& profile, double& center) {
  const Curve curve =
      curve_of(field.visibility, seed, dark, dark.reference_count, bright, bright.reference_count);
  const std::vector<double> fitted = fit_nondecreasing(curve.value);
  const bool saturated = dark.end == WalkEnd::saturated && bright.end == WalkEnd::saturated;
  if (!saturated && !spans(fitted, settings.reach)) {
    return broken(dark) || broken(bright) ? ProfileOutcome::discontinuity : ProfileOutcome::unreached;
  }
  const Curve noise =
      curve_of(field.visibility_se, seed, dark, dark.reference_count, bright, bright.reference_count);
  // A pixel's position along the walk is exact, so a noise-free profile may leave its fit by rounding only.
  constexpr double kRounding = 0.01;
  if (rms_between(curve.value, fitted) > 3.0 * rms(noise.value) + kRounding)
    return ProfileOutcome::not_monotone;
  const auto transition = measure_transition(curve.position, fitted);
  if (!transition) return ProfileOutcome::unreached;

  const double walked_px = glm::length(ascent.direction_px) * static_cast<double>(curve.value.size() - 1);
  profile.reference_width_world = transition->width;
  profile.reference_width_10_90_world = transition->width_10_90;
  profile.reference_width_px =
      transition->width * walked_px / (curve.position.back() - curve.position.front());
  center = transition->center;
  return profile.reference_width_px < settings.min_width_px ? ProfileOutcome::too_narrow
                                                            : ProfileOutcome::accepted;
}

ProfileOutcome judge_test(std::span<const float> test, size_t seed, const Walk& dark, const Walk& bright,
                          const PenumbraSettings& settings, double reference_center,
                          PenumbraProfile& profile) {
  const Curve curve = curve_of(test, seed, dark, dark.test_count, bright, bright.test_count);
  const std::vector<double> fitted = fit_nondecreasing(curve.value);
  if (!spans(fitted, settings.test_reach)) return ProfileOutcome::test_unreached;
  const bool cut_dark = dark.test_cut && fitted.front() > 1.0 - settings.reach;
  const bool cut_bright = bright.test_cut && fitted.back() < settings.reach;
  if (cut_dark || cut_bright) return ProfileOutcome::test_unreached;
  if (rms_between(curve.value, fitted) > settings.max_test_rms) return ProfileOutcome::test_not_monotone;
  const auto transition = measure_transition(curve.position, fitted);
  if (!transition) return ProfileOutcome::test_unreached;
  profile.test_width_world = transition->width;
  profile.test_width_10_90_world = transition->width_10_90;
  profile.offset_world = transition->center - reference_center;
  return ProfileOutcome::accepted;
}

void count_levels(const ReferenceField& field, std::span<const float> test, size_t seed, const Walk& dark,
                  const Walk& bright, PenumbraProfile& profile) {
  std::vector<long> levels;
  const auto add = [&](size_t i) {
    if (field.visibility[i] > 0.05f && field.visibility[i] < 0.95f) {
      levels.push_back(std::lround(4096.0 * test[i]));
    }
  };
  add(seed);
  for (const Walk* walk : {&dark, &bright}) {
    for (size_t k = 0; k < walk->reference_count; ++k) add(walk->samples[k].pixel);
  }
  profile.ramp_px = levels.size();
  std::sort(levels.begin(), levels.end());
  profile.ramp_levels = static_cast<size_t>(std::unique(levels.begin(), levels.end()) - levels.begin());
}

PenumbraProfile measure_profile(const ReferenceField& field, std::span<const float> test, const Seed& seed,
                                const PenumbraSettings& settings) {
  const size_t width = static_cast<size_t>(field.surface.width);
  PenumbraProfile profile;
  profile.x = static_cast<int>(seed.pixel % width);
  profile.y = static_cast<int>(seed.pixel / width);
  profile.outcome = seed.on_ridge ? ProfileOutcome::discontinuity : ProfileOutcome::no_ridge;
  const auto ascent = fit_ascent(field, seed.pixel);
  if (!ascent) return profile;
  profile.reference_width_px = ascent->width_px;
  if (!seed.on_ridge) return profile;

  const Walk dark = walk_profile(field, test, seed.pixel, *ascent, false, settings.max_length_px);
  const Walk bright = walk_profile(field, test, seed.pixel, *ascent, true, settings.max_length_px);
  double center = 0.0;
  profile.outcome = judge_reference(field, seed.pixel, *ascent, dark, bright, settings, profile, center);
  const bool too_narrow = profile.outcome == ProfileOutcome::too_narrow;
  if (profile.outcome != ProfileOutcome::accepted && !too_narrow) return profile;
  PenumbraProfile judged = profile;
  judged.outcome = judge_test(test, seed.pixel, dark, bright, settings, center, judged);
  if (judged.outcome == ProfileOutcome::accepted) judged.edge_offset_world = judged.offset_world;
  if (too_narrow) {
    profile.edge_offset_world = judged.edge_offset_world;
    return profile;
  }
  count_levels(field, test, seed.pixel, dark, bright, judged);
  return judged;
}

bool is_measured(const PenumbraProfile& profile) {
  return profile.reference_width_world > 0.0;
}

// The slope of a saddle or a faint penumbra's middle tells no width: what was not measured is no wider than
// what was.
void limit_widths(std::vector<PenumbraProfile>& profiles) {
  double widest_px = 0.0;
  for (const PenumbraProfile& profile : profiles) {
    if (is_measured(profile)) widest_px = std::max(widest_px, profile.reference_width_px);
  }
  if (widest_px == 0.0) return;
  for (PenumbraProfile& profile : profiles) {
    if (!is_measured(profile)) profile.reference_width_px = std::min(profile.reference_width_px, widest_px);
  }
}

constexpr std::array<std::string_view, kProfileOutcomes> kOutcomeNames = {
    "accepted",     "no_ridge",   "discontinuity",  "unreached",
    "not_monotone", "too_narrow", "test_unreached", "test_not_monotone"};

void require_settings(const PenumbraSettings& settings) {
  if (settings.seed_spacing_px < 1)
    fail_input(fmt::format("seed_spacing_px is {}", settings.seed_spacing_px));
  if (settings.max_length_px < 1) fail_input(fmt::format("max_length_px is {}", settings.max_length_px));
}

}  // namespace

// By the delta method: the root's slope times the standard error of the mean square.
double rms_se(std::span<const double> values) {
  const double n = static_cast<double>(values.size()), root = rms(values);
  if (values.size() < 2 || root == 0.0) return 0.0;
  double sum = 0.0;
  for (const double value : values) sum += std::pow(value * value - root * root, 2);
  return std::sqrt(sum / (n * (n - 1.0))) / (2.0 * root);
}

std::optional<Spread> spread_of(std::vector<double> values) {
  if (values.empty()) return std::nullopt;
  std::sort(values.begin(), values.end());
  const auto quantile = [&](double q) {
    const double at = q * static_cast<double>(values.size() - 1);
    const size_t below = static_cast<size_t>(at);
    return std::lerp(values[below], values[std::min(below + 1, values.size() - 1)],
                     at - static_cast<double>(below));
  };
  return Spread{quantile(0.5), quantile(0.05), quantile(0.95), rms(values), rms_se(values), values.size()};
}

PenumbraError measure_penumbra(const Image& test, const Image& reference, std::span<const uint8_t> mask,
                               const PenumbraSettings& settings) {
  require_settings(settings);
  require_same_size(test, reference, "penumbra");
  require_mask_size(reference, mask, "penumbra");
  require_visibility(test, "visibility", mask);
  require_visibility(reference, "visibility", mask);
  require_range(reference, "visibility_se", mask, 0.0f, std::numeric_limits<float>::max());
  const ReferenceField field = {checked_surface(reference), reference.plane("visibility"),
                                reference.plane("visibility_se"), mask};
  const std::span<const float> v = test.plane("visibility");

  const TileGrid cells = {test.width, test.height, settings.seed_spacing_px};
  const auto found = for_each_tile<std::optional<PenumbraProfile>>(
      cells, [&](const Tile& cell, std::optional<PenumbraProfile>& profile) {
        if (const auto seed = find_seed(field, cell)) profile = measure_profile(field, v, *seed, settings);
      });

  PenumbraError out;
  std::vector<double> octaves, octaves_10_90, offsets;
  for (const auto& profile : found) {
    if (!profile) continue;
    out.profiles.push_back(*profile);
    ++out.outcomes[static_cast<size_t>(profile->outcome)];
    if (profile->outcome != ProfileOutcome::accepted) continue;
    octaves.push_back(std::log2(profile->test_width_world / profile->reference_width_world));
    octaves_10_90.push_back(
        std::log2(profile->test_width_10_90_world / profile->reference_width_10_90_world));
    offsets.push_back(profile->offset_world);
  }
  limit_widths(out.profiles);
  out.width_octaves = spread_of(octaves);
  out.width_10_90_octaves = spread_of(octaves_10_90);
  out.offset_world = spread_of(offsets);
  return out;
}

std::string_view name_of(ProfileOutcome outcome) {
  return kOutcomeNames[static_cast<size_t>(outcome)];
}

}  // namespace umbrameter
