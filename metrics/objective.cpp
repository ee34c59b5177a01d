// SPDX-License-Identifier: Apache-2.0
#include "metrics/objective.h"

#include "core/error.h"
#include "core/names.h"
#include "metrics/diagnosis.h"
#include "metrics/image/parity.h"
#include "metrics/statistics/bootstrap.h"

#include <array>
#include <cmath>
#include <vector>

namespace umbrameter {
namespace {

const std::array<std::string, 3> kTermNames = {"rmse", "penumbra", "faults"};
constexpr std::array<std::string_view, 3> kTermUnits = {"visibility", "octaves", "weighted faults"};
constexpr int kRounds = 1000;
constexpr int kLeastRounds = 100;  // a bootstrap refuses fewer

// Where a term of `faults` is 1.
constexpr double kAcneError = 0.001, kLeakError = 0.001, kOffsetWidths = 0.1, kWidthOctaves = 0.5;

std::optional<ObjectiveValue> measure_rmse(const Image& test, const Image& reference,
                                           std::span<const uint8_t> mask, bool with_interval) {
  VisibilityErrorSettings settings;
  if (!with_interval) settings.bootstrap_rounds = kLeastRounds;
  const VisibilityError error = measure_visibility_error(test, reference, mask, settings);
  if (!error.rmse) return std::nullopt;
  return ObjectiveValue{error.rmse->value, with_interval ? error.rmse : std::nullopt};
}

/// Squared octaves of every profile that the truth has; absent for the others.
std::optional<double> squared_octaves(const PenumbraProfile& profile) {
  switch (profile.outcome) {
    case ProfileOutcome::accepted: {
      // Lost is as wrong as an edge can be.
      return std::min(profile.width_octaves * profile.width_octaves, kLostOctaves * kLostOctaves);
    }
    case ProfileOutcome::test_unreached:
    case ProfileOutcome::test_not_monotone:
      return kLostOctaves * kLostOctaves;
    default:
      return std::nullopt;
  }
}

std::optional<ObjectiveValue> measure_widths(const Image& test, const Image& reference,
                                             std::span<const uint8_t> mask, bool with_interval) {
  std::vector<TileSum> squares;
  TileSum total;
  for (const PenumbraProfile& profile : measure_penumbra(test, reference, mask).profiles) {
    const auto squared = squared_octaves(profile);
    if (!squared) continue;
    squares.push_back({*squared, 1.0});
    total.sum += *squared;
    total.weight += 1.0;
  }
  if (squares.empty()) return std::nullopt;
  ObjectiveValue out{std::sqrt(total.sum / total.weight), {}};
  if (!with_interval) return out;
  if (const auto interval = bootstrap_ratio(squares, kRounds, 1))
    out.interval = Interval{out.value, std::sqrt(interval->low), std::sqrt(interval->high)};
  return out;
}

std::optional<ObjectiveValue> measure_faults(const Image& test, const Image& reference,
                                             std::span<const uint8_t> mask) {
  const Diagnosis diagnosis = diagnose(test, reference, mask).numbers;
  const FaultNumbers& faults = diagnosis.faults;
  if (!faults.mean_abs_error) return std::nullopt;
  double leaks = 0.0;
  for (const FaultClass leak :
       {FaultClass::peter_panning, FaultClass::bleed, FaultClass::geometric_leak, FaultClass::lost_shadow})
    leaks += faults.of(leak).mean_abs_error;
  double sum = faults.of(FaultClass::acne).mean_abs_error / kAcneError + leaks / kLeakError;
  if (diagnosis.penumbra.offset_widths)
    sum += std::abs(diagnosis.penumbra.offset_widths->median) / kOffsetWidths;
  if (const auto widths = measure_widths(test, reference, mask, false)) sum += widths->value / kWidthOctaves;
  return ObjectiveValue{sum, {}};
}

}  // namespace

Objective choose_objective(const std::string& name) {
  for (size_t i = 0; i < kTermNames.size(); ++i) {
    if (name == kTermNames[i]) return static_cast<Objective>(i);
  }
  fail_input(fmt::format("unknown objective '{}'", name), {}, suggest_name(name, kTermNames));
}

std::string_view name_of(Objective objective) {
  return kTermNames[static_cast<size_t>(objective)];
}

std::string_view unit_of(Objective objective) {
  return kTermUnits[static_cast<size_t>(objective)];
}

std::optional<ObjectiveValue> measure_objective(Objective objective, const Image& test,
                                                const Image& reference, std::span<const uint8_t> all,
                                                bool with_interval) {
  const std::vector<uint8_t> mask = known_mask(all, test);
  switch (objective) {
    case Objective::rmse:
      return measure_rmse(test, reference, mask, with_interval);
    case Objective::penumbra:
      return measure_widths(test, reference, mask, with_interval);
    case Objective::faults:
      return measure_faults(test, reference, mask);
  }
  return std::nullopt;
}

std::optional<double> measure_width_octaves(const Image& test, const Image& reference,
                                            std::span<const uint8_t> mask) {
  const auto octaves = measure_penumbra(test, reference, known_mask(mask, test)).width_octaves;
  return octaves ? std::optional(octaves->median) : std::nullopt;
}

FaultShares measure_fault_shares(const Image& test, const Image& reference, std::span<const uint8_t> all) {
  const std::vector<uint8_t> mask = known_mask(all, test);
  const auto profiles = measure_penumbra(test, reference, mask).profiles;
  const Faults faults =
      classify_faults(test, reference, mask, profiles, measure_envelope(test, reference, mask, profiles));
  if (faults.scored_pixels == 0) return {};
  const auto share = [&](FaultClass fault) {
    return static_cast<double>(faults.of(fault).pixels) / static_cast<double>(faults.scored_pixels);
  };
  return {share(FaultClass::acne), share(FaultClass::peter_panning)};
}

}  // namespace umbrameter
