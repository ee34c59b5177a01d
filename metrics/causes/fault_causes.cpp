// SPDX-License-Identifier: Apache-2.0
#include "metrics/causes/fault_causes.h"

#include "core/error.h"
#include "metrics/causes/substitutions.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace umbrameter {
namespace {

constexpr double kAlike = 0.05;  // of a fault; less does not tell two substitutions apart

using ErrorSums = std::array<double, kFaultClasses>;

void require_same_pixels(const Image& image, std::span<const FaultClass> classes) {
  if (image.pixel_count() == classes.size()) return;
  fail_input(
      fmt::format("a picture of {} x {} px has {} fault classes", image.width, image.height, classes.size()));
}

ErrorSums sums_by_class(const Image& image, const Image& reference, std::span<const FaultClass> classes) {
  require_same_pixels(image, classes);
  require_same_pixels(reference, classes);
  const auto v = image.plane("visibility"), r = reference.plane("visibility");
  ErrorSums sums{};
  for (size_t i = 0; i < classes.size(); ++i)
    sums[static_cast<size_t>(classes[i])] += std::abs(static_cast<double>(v[i]) - r[i]);
  return sums;
}

bool replaces_much(std::string_view id) {
  const Substitution* substitution = find_substitution(id);
  return substitution != nullptr && substitution->replaces_much;
}

bool is_of(RunPart part, const SubstitutionOutcome* outcome) {
  const Substitution* substitution = find_substitution(outcome->id);
  return substitution != nullptr && substitution->part == part;
}

/// Where `reason` mends as much as `effect`, the effect was wrong because of it.
void leave_out(RunPart effect, RunPart reason, std::vector<const SubstitutionOutcome*>& alike) {
  const auto is_reason = [&](const auto* outcome) { return is_of(reason, outcome); };
  if (std::ranges::none_of(alike, is_reason)) return;
  std::erase_if(alike, [&](const auto* outcome) { return is_of(effect, outcome); });
}

/// A filter's width follows from the blockers' distance, and that from the map it is read from.
void leave_out_what_follows(std::vector<const SubstitutionOutcome*>& alike) {
  leave_out(RunPart::filter_size, RunPart::blocker_distance, alike);
  leave_out(RunPart::blocker_distance, RunPart::map_size, alike);
}

const SubstitutionOutcome* best_of(std::vector<const SubstitutionOutcome*> outcomes, size_t index) {
  double most = -HUGE_VAL;
  for (const SubstitutionOutcome* outcome : outcomes) most = std::max(most, outcome->removed[index]);
  std::erase_if(outcomes, [&](const auto* outcome) { return outcome->removed[index] < most - kAlike; });
  leave_out_what_follows(outcomes);
  const auto least_harm = std::ranges::min_element(outcomes, {}, &SubstitutionOutcome::elsewhere);
  return least_harm == outcomes.end() ? nullptr : *least_harm;
}

size_t scored_pixels(std::span<const FaultClass> classes) {
  return classes.size() - static_cast<size_t>(std::ranges::count(classes, FaultClass::unscored));
}

}  // namespace

std::vector<CausedFault> caused_faults(std::span<const FaultClass> classes, const Image& test,
                                       const Image& reference, std::span<const FaultClass> faults) {
  const ErrorSums sums = sums_by_class(test, reference, classes);
  const auto scored = static_cast<double>(scored_pixels(classes));
  std::vector<CausedFault> caused;
  for (const FaultClass fault : faults) {
    const double sum = sums[static_cast<size_t>(fault)];
    if (sum > 0.0)
      caused.push_back({fault, static_cast<size_t>(std::ranges::count(classes, fault)), sum / scored});
  }
  return caused;
}

void measure_substitution(const Image& substituted, const Image& test, const Image& reference,
                          std::span<const FaultClass> classes, std::span<const CausedFault> faults,
                          SubstitutionOutcome& outcome) {
  ErrorSums before = sums_by_class(test, reference, classes);
  ErrorSums after = sums_by_class(substituted, reference, classes);
  before[static_cast<size_t>(FaultClass::unscored)] = after[static_cast<size_t>(FaultClass::unscored)] = 0.0;
  outcome.removed.clear();
  for (const CausedFault& fault : faults) {
    const auto k = static_cast<size_t>(fault.fault);
    outcome.removed.push_back(1.0 - after[k] / before[k]);
    before[k] = after[k] = 0.0;
  }
  double added = 0.0;
  for (size_t k = 0; k < kFaultClasses; ++k) added += after[k] - before[k];
  outcome.elsewhere = added / static_cast<double>(scored_pixels(classes));
}

const SubstitutionOutcome* best_substitution(const FaultCauses& causes, size_t index) {
  std::vector<const SubstitutionOutcome*> sparing, simple, all;
  for (const SubstitutionOutcome& outcome : causes.outcomes) {
    if (outcome.not_tried) continue;
    all.push_back(&outcome);
    if (replaces_much(outcome.id)) continue;
    simple.push_back(&outcome);
    const double mended = outcome.removed[index] * causes.faults[index].mean_abs_error;
    if (outcome.elsewhere <= mended) sparing.push_back(&outcome);
  }
  for (const auto& some : {sparing, simple}) {
    const SubstitutionOutcome* best = best_of(some, index);
    if (best != nullptr && best->removed[index] >= kMends) return best;
  }
  return best_of(all, index);
}

const SubstitutionOutcome* cause_of(const FaultCauses& causes, size_t index) {
  const SubstitutionOutcome* best = best_substitution(causes, index);
  return best != nullptr && best->removed[index] >= kMends ? best : nullptr;
}

}  // namespace umbrameter
