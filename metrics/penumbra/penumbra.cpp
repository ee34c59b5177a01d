// SPDX-License-Identifier: Apache-2.0
#include "metrics/penumbra/penumbra.h"

#include "core/error.h"
#include "metrics/image/checks.h"
#include "metrics/penumbra/penumbra_judge.h"
#include "metrics/penumbra/penumbra_walk.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace umbrameter {

namespace {

// A faint shadow's flank is a profile of its own only where no half of it leads to a ridge.
bool crosses_half(const ReferenceField& field, const Walk& walk, float own) {
  return std::any_of(walk.samples.begin(), walk.samples.end(), [&](const WalkSample& sample) {
    return (field.visibility[sample.pixel] < 0.5f) != (own < 0.5f);
  });
}

std::optional<PenumbraProfile> measure_flank(const ReferenceField& field, std::span<const float> test,
                                             size_t seed, const PenumbraProfile& found,
                                             const PenumbraSettings& settings) {
  const auto ascent = fit_ascent(field, seed);
  if (!ascent) return std::nullopt;
  const Walk dark = walk_profile(field, test, seed, *ascent, false, settings.max_length_px);
  const Walk bright = walk_profile(field, test, seed, *ascent, true, settings.max_length_px);
  const float own = field.visibility[seed];
  // A flank leads to light or shade that turns round, not out of sight.
  if ((own < 0.5f ? bright : dark).end == WalkEnd::broken) return std::nullopt;
  if (crosses_half(field, dark, own) || crosses_half(field, bright, own)) return std::nullopt;
  PenumbraProfile profile = found;
  judge_stretch({field, test, seed, *ascent, dark, bright}, settings, profile);
  return profile.outcome == ProfileOutcome::accepted ? std::optional(profile) : std::nullopt;
}

PenumbraProfile measure_profile(const ReferenceField& field, std::span<const float> test, const Seed& seed,
                                const PenumbraSettings& settings) {
  const size_t width = static_cast<size_t>(field.surface.width);
  PenumbraProfile profile;
  profile.x = static_cast<int>(seed.pixel % width);
  profile.y = static_cast<int>(seed.pixel / width);
  profile.has_ridge = seed.on_ridge;
  profile.outcome = seed.on_ridge ? ProfileOutcome::discontinuity : ProfileOutcome::no_ridge;
  if (const auto ascent = fit_ascent(field, seed.pixel)) {
    profile.reference_width_px = ascent->width_px;
    if (seed.on_ridge) {
      const Walk dark = walk_profile(field, test, seed.pixel, *ascent, false, settings.max_length_px);
      const Walk bright = walk_profile(field, test, seed.pixel, *ascent, true, settings.max_length_px);
      judge_profile({field, test, seed.pixel, *ascent, dark, bright}, settings, profile);
    }
  }
  if (!seed.on_ridge && seed.flank) {
    if (const auto flank = measure_flank(field, test, *seed.flank, profile, settings)) return *flank;
  }
  return profile;
}

bool is_measured(const PenumbraProfile& profile) {
  return profile.reference_width_world > 0.0 && !profile.is_partial;
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

double rms(std::span<const double> values) {
  double sum = 0.0;
  for (const double value : values) sum += value * value;
  return std::sqrt(sum / static_cast<double>(values.size()));
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
  for (const auto& profile : found) {
    if (!profile) continue;
    out.profiles.push_back(*profile);
    ++out.outcomes[static_cast<size_t>(profile->outcome)];
    out.partial += profile->is_partial ? 1 : 0;
  }
  // A stretch's width and place depend on its neighbour's; they speak only where no profile is whole.
  const bool any_whole = out.outcomes[0] > out.partial;
  std::vector<double> octaves, octaves_10_90, offsets;
  for (const auto& profile : found) {
    if (!profile || profile->outcome != ProfileOutcome::accepted || (any_whole && profile->is_partial))
      continue;
    octaves.push_back(profile->width_octaves);
    octaves_10_90.push_back(profile->width_10_90_octaves);
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
