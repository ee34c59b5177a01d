// SPDX-License-Identifier: Apache-2.0
#include "results/causes_format.h"

#include "metrics/causes/substitutions.h"
#include "results/diagnosis_format.h"
#include "results/format.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

namespace umbrameter {
namespace {

constexpr double kUnchanged = 0.005;  // half a percent
constexpr double kHarms = 0.1;        // of the fault, elsewhere

/// What a fault's name makes one suspect; absent where it suggests no part of a run.
std::optional<RunPart> suspect_of(FaultClass fault) {
  switch (fault) {
    case FaultClass::acne:
    case FaultClass::terminator:
    case FaultClass::peter_panning:
      return RunPart::bias;
    case FaultClass::penumbra:
    case FaultClass::overlap:
    case FaultClass::penumbra_too_wide:
      return RunPart::filter_size;
    case FaultClass::resolution:
      return RunPart::map_size;
    case FaultClass::geometric_leak:
    case FaultClass::lost_shadow:
      return RunPart::map_fit;
    default:
      return std::nullopt;
  }
}

const Substitution& substitution_of(const SubstitutionOutcome& outcome) {
  const Substitution* known = find_substitution(outcome.id);
  static constexpr Substitution kUnknown{"", RunPart::bias, 1.0, "another substitution", "of another version",
                                         1.0};
  return known == nullptr ? kUnknown : *known;
}

std::string percent(double share) {
  return fmt::format("{:.0f} %", 100.0 * share);
}

std::string removed_text(double removed) {
  if (std::abs(removed) < kUnchanged) return "no change";
  return removed > 0.0 ? percent(removed) : fmt::format("worse x {:.2g}", 1.0 - removed);
}

/// "no bias mends it" where its name suggests the bias, which was tried in vain.
std::string innocent_suspect(const FaultCauses& causes, size_t index) {
  const auto suspect = suspect_of(causes.faults[index].fault);
  if (!suspect) return "";
  bool is_tried = false;
  for (const SubstitutionOutcome& outcome : causes.outcomes) {
    if (outcome.not_tried || substitution_of(outcome).part != *suspect) continue;
    if (outcome.removed[index] >= kMends) return "";
    is_tried = true;
  }
  return is_tried ? fmt::format("no {} mends it; ", name_of(*suspect)) : "";
}

std::string harm_text(const SubstitutionOutcome& outcome, const CausedFault& fault) {
  if (outcome.elsewhere <= kHarms * fault.mean_abs_error) return "";
  return fmt::format(" (and adds {} elsewhere)", format_error(outcome.elsewhere));
}

bool is_mended_by(RunPart part, const FaultCauses& causes, size_t index) {
  return std::ranges::any_of(causes.outcomes, [&](const SubstitutionOutcome& outcome) {
    return !outcome.not_tried && substitution_of(outcome).part == part && outcome.removed[index] >= kMends;
  });
}

/// More taps would find what a sparse search misses, maps from elsewhere what the map does not hold.
std::string_view meaning_of(const Substitution& substitution, const FaultCauses& causes, size_t index) {
  const bool is_of_map = substitution.part == RunPart::blocker_distance &&
                         is_mended_by(RunPart::light_points, causes, index) &&
                         !is_mended_by(RunPart::taps, causes, index);
  return is_of_map ? "the search does not find these blockers in one map from the light's centre"
                   : substitution.meaning;
}

std::string mended(const SubstitutionOutcome& outcome, const FaultCauses& causes, size_t index) {
  const Substitution& substitution = substitution_of(outcome);
  return fmt::format("{} removes {}{}: {}", substitution.label, percent(outcome.removed[index]),
                     harm_text(outcome, causes.faults[index]), meaning_of(substitution, causes, index));
}

std::string sentence(const FaultCauses& causes, size_t index) {
  const CausedFault& fault = causes.faults[index];
  const std::string name =
      fmt::format("{} {}", format_fault(fault.fault), format_error(fault.mean_abs_error));
  const SubstitutionOutcome* best = best_substitution(causes, index);
  if (best == nullptr) return name + ": nothing could be tried";
  const double removed = best->removed[index];
  if (removed >= kMends)
    return fmt::format("{}: {}{}", name, innocent_suspect(causes, index), mended(*best, causes, index));
  if (removed < kUnchanged) return name + ": nothing that was tried mends it";
  return fmt::format("{}: nothing that was tried mends it; most does {}: {}", name,
                     substitution_of(*best).label, percent(removed));
}

}  // namespace

std::vector<std::string> cause_sentences(const FaultCauses& causes) {
  std::vector<std::string> sentences;
  if (causes.skipped) return sentences;
  for (size_t i = 0; i < causes.faults.size(); ++i) sentences.push_back(sentence(causes, i));
  return sentences;
}

TermLines substitution_lines(const FaultCauses& causes) {
  if (causes.skipped) return {{"causes", *causes.skipped}};
  TermLines lines;
  for (std::string& text : cause_sentences(causes)) lines.emplace_back("cause", std::move(text));
  return lines;
}

std::vector<std::vector<std::string>> cause_table(const FaultCauses& causes) {
  std::vector<std::string> head = {"instead"};
  for (const CausedFault& fault : causes.faults) head.push_back(format_fault(fault.fault));
  head.emplace_back("elsewhere");
  head.emplace_back("changed");
  std::vector<std::vector<std::string>> rows = {head};
  for (const SubstitutionOutcome& outcome : causes.outcomes) {
    std::vector<std::string> row = {std::string(substitution_of(outcome).label)};
    for (size_t i = 0; i < causes.faults.size(); ++i)
      row.push_back(outcome.not_tried ? "not tried" : removed_text(outcome.removed[i]));
    row.push_back(outcome.not_tried ? "" : format_signed_error(outcome.elsewhere));
    row.push_back(outcome.not_tried ? *outcome.not_tried
                                    : fmt::format("{}", fmt::join(outcome.changes, ", ")));
    rows.push_back(std::move(row));
  }
  return rows;
}

}  // namespace umbrameter
